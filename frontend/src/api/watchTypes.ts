/** Reports of stations. The Python side is in app/supervision, app/operations and app/monitoring. */

type Quality = "good" | "attention" | "bad" | "neutral";

export interface DeviceReport {
  name: "arm" | "camera";
  state: "connected" | "connecting" | "lost" | "off";
  text: string;
  age_s: number | null;
  rate_hz: number | null;
  received: number;
  lost: number;
  corrupt: number;
}

export interface ActivityReport {
  kind: "idle" | "calibrating" | "verifying" | "checking_arm" | "scanning" | "working";
  title: string;
  /** Counted from 1; 0 where there are no steps. */
  step: number;
  steps: number;
  progress: string;
  points: number;
  rate_points_s: number;
  lost_frames: number;
}

export interface CalibrationReport {
  name: string;
  accepted_at: string;
  age_days: number;
  total_um: number;
  quality: Quality;
  due: boolean;
  due_in_days: number;
}

export interface VerificationReport {
  title: string;
  at: string;
  quality: Quality;
  text: string;
}

export interface Alarm {
  quality: Quality;
  text: string;
  remedy: string;
}

/** Everything of one station at one moment. */
export interface StationReport {
  format: "crenel/station-report";
  station: string;
  instance: string;
  name: string;
  version: string;
  simulated: boolean;
  /** Of its pages, or empty. */
  address: string;
  at: string;
  up_s: number;
  devices: DeviceReport[];
  laser_on: boolean;
  activity: ActivityReport;
  calibration: CalibrationReport | null;
  verification: VerificationReport | null;
  alarms: Alarm[];
  temperature_c: number | null;
  disk_free_gb: number;
  control: string | null;
}

export interface StationEvent {
  format: "crenel/station-event";
  station: string;
  instance: string;
  number: number;
  at: string;
  kind: string;
  quality: Quality;
  text: string;
}

/** Another station, as it is heard of by the broker. */
export interface StationShown {
  id: string;
  name: string;
  state: "live" | "lost" | "off" | "waiting" | "unknown";
  /** Since its last report; null before the first. */
  silent_s: number | null;
  /** With the worst of its alarms alone. */
  report: StationReport | null;
  alarms: number;
  /** The newest, if any. */
  events: StationEvent[];
}

/** A notification. */
export interface Told {
  format: "crenel/notice";
  number: number;
  station: string;
  instance: string;
  name: string;
  kind: "done" | "fault" | "due" | "test";
  at: string;
  text: string;
}

export interface HealthItem {
  id: string;
  title: string;
  quality: Quality;
  what: string;
  why: string;
  remedy: string;
}

export interface Health {
  at: string;
  quality: Quality;
  items: HealthItem[];
}

export interface BackupMade {
  folder: string;
  at: string;
  files: number;
  bytes: number;
}

export interface BackupState {
  /** Done of the one that is being made; null while none is. */
  share: number | null;
  folder: string;
  last: BackupMade | null;
  trouble: string;
}

export interface HealthView {
  health: Health;
  backup: BackupState;
}

export interface LogLine {
  at: string;
  level: "info" | "warning" | "error";
  logger: string;
  thread: string;
  text: string;
  trace: string;
}

/** The secret itself is never displayed again. */
export interface Notifications {
  url: string;
  has_secret: boolean;
  done: boolean;
  fault: boolean;
  due: boolean;
  sent: number;
  given_up: number;
  waiting: number;
  trouble: string;
}

export interface Scraper {
  id: string;
  name: string;
  made_by: string;
  made_at: string;
  /** Only where it was made just now. */
  token: string | null;
}
