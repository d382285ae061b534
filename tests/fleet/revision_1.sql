BEGIN TRANSACTION;
CREATE TABLE alembic_version (
	version_num VARCHAR(32) NOT NULL, 
	CONSTRAINT alembic_version_pkc PRIMARY KEY (version_num)
);
INSERT INTO alembic_version (version_num) VALUES('0001');
CREATE TABLE figure (
	record_key INTEGER NOT NULL, 
	number INTEGER NOT NULL, 
	station VARCHAR NOT NULL, 
	at DATETIME NOT NULL, 
	symbol VARCHAR NOT NULL, 
	quantity VARCHAR NOT NULL, 
	value DOUBLE NOT NULL, 
	unit VARCHAR NOT NULL, 
	expanded_uncertainty DOUBLE, 
	limit_value DOUBLE, 
	decision VARCHAR NOT NULL, 
	PRIMARY KEY (record_key, number), 
	FOREIGN KEY(record_key) REFERENCES record ("key") ON DELETE CASCADE
);
INSERT INTO figure (record_key, number, station, at, symbol, quantity, value, unit, expanded_uncertainty, limit_value, decision) VALUES(1,0,'room-1','2026-05-04 10:11:00.000000','L_Dia.2x1:Ps:ODS','location-scan',12.5,'µm',2.5,40.0,'pass');
CREATE TABLE file (
	record_key INTEGER NOT NULL, 
	path VARCHAR NOT NULL, 
	bytes BIGINT NOT NULL, 
	sha256 VARCHAR NOT NULL, 
	PRIMARY KEY (record_key, path), 
	FOREIGN KEY(record_key) REFERENCES record ("key") ON DELETE CASCADE
);
INSERT INTO file (record_key, path, bytes, sha256) VALUES(1,'performance.json',7,'dddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddd');
CREATE TABLE record (
	"key" INTEGER NOT NULL, 
	station VARCHAR NOT NULL, 
	kind VARCHAR NOT NULL, 
	id VARCHAR NOT NULL, 
	content VARCHAR NOT NULL, 
	at DATETIME NOT NULL, 
	label VARCHAR NOT NULL, 
	operator VARCHAR NOT NULL, 
	arm_serial VARCHAR NOT NULL, 
	sensor_serial VARCHAR NOT NULL, 
	object_serial VARCHAR NOT NULL, 
	calibration_sha256 VARCHAR NOT NULL, 
	arm_sha256 VARCHAR NOT NULL, 
	software VARCHAR NOT NULL, 
	verdict VARCHAR NOT NULL, 
	place VARCHAR NOT NULL, 
	simulated BOOLEAN NOT NULL, 
	calibration_id VARCHAR NOT NULL, 
	temperature_c DOUBLE, 
	points BIGINT, 
	current_at DATETIME NOT NULL, 
	archived_at DATETIME, 
	size_bytes BIGINT NOT NULL, 
	PRIMARY KEY ("key"), 
	CONSTRAINT one_record UNIQUE (station, kind, id), 
	FOREIGN KEY(station) REFERENCES station (id)
);
INSERT INTO record (key, station, kind, id, content, at, label, operator, arm_serial, sensor_serial, object_serial, calibration_sha256, arm_sha256, software, verdict, place, simulated, calibration_id, temperature_c, points, current_at, archived_at, size_bytes) VALUES(1,'room-1','performance','20260504-101500-ab12','0000000000000001','2026-05-04 10:11:00.000000','','Ada','A-17','L-3','','','','crenel 0.1.0','pass','/data',FALSE,'20260501-090000-cd34',20.5,NULL,'2026-05-04 12:00:00.000000',NULL,12);
INSERT INTO record (key, station, kind, id, content, at, label, operator, arm_serial, sensor_serial, object_serial, calibration_sha256, arm_sha256, software, verdict, place, simulated, calibration_id, temperature_c, points, current_at, archived_at, size_bytes) VALUES(2,'room-1','scan','20260504-111500','0000000000000002','2026-05-04 10:12:00.000000','Housing 4711','Ada','A-17','L-3','','','','crenel 0.1.0','','/data',FALSE,'20260501-090000-cd34',20.5,12345,'2026-05-04 12:00:00.000000',NULL,12);
CREATE TABLE station (
	id VARCHAR NOT NULL, 
	name VARCHAR NOT NULL, 
	collected_at DATETIME, 
	problem VARCHAR NOT NULL, 
	PRIMARY KEY (id)
);
INSERT INTO station (id, name, collected_at, problem) VALUES('room-1','Measuring room 1','2026-05-04 12:00:00.000000','');
CREATE INDEX record_in_time ON record (at);
CREATE INDEX record_of_station ON record (station, at);
CREATE INDEX record_of_kind ON record (kind, at);
CREATE INDEX record_of_calibration ON record (calibration_id);
CREATE INDEX figure_in_time ON figure (quantity, station, at);
CREATE INDEX figure_of_symbol ON figure (symbol, station, at);
COMMIT;
