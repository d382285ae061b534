"""Stations, their records, and the files and figures of these."""

import sqlalchemy as sa
from alembic import op

revision = "0001"
down_revision = None

KEY = sa.BigInteger().with_variant(sa.Integer, "sqlite")
WORDS = sa.String().with_variant(sa.String(collation="C"), "postgresql")
MOMENT = sa.DateTime(timezone=True)
TEXTS = (
    *("label", "operator", "arm_serial", "sensor_serial", "object_serial"),
    *("calibration_sha256", "arm_sha256", "software", "verdict", "place"),
)


def upgrade() -> None:
    """From an empty database."""
    op.create_table(
        "station",
        sa.Column("id", WORDS, primary_key=True),
        sa.Column("name", sa.String, nullable=False),
        sa.Column("collected_at", MOMENT),
        sa.Column("problem", sa.String, nullable=False),
    )
    op.create_table(
        "record",
        sa.Column("key", KEY, primary_key=True, autoincrement=True),
        sa.Column("station", WORDS, sa.ForeignKey("station.id"), nullable=False),
        sa.Column("kind", WORDS, nullable=False),
        sa.Column("id", WORDS, nullable=False),
        sa.Column("content", sa.String, nullable=False),
        sa.Column("at", MOMENT, nullable=False),
        *(sa.Column(name, sa.String, nullable=False) for name in TEXTS),
        sa.Column("simulated", sa.Boolean, nullable=False),
        sa.Column("calibration_id", WORDS, nullable=False),
        sa.Column("temperature_c", sa.Double),
        sa.Column("points", sa.BigInteger),
        sa.Column("current_at", MOMENT, nullable=False),
        sa.Column("archived_at", MOMENT),
        sa.Column("size_bytes", sa.BigInteger, nullable=False),
        sa.UniqueConstraint("station", "kind", "id", name="one_record"),
    )
    op.create_index("record_in_time", "record", ["at"])
    op.create_index("record_of_station", "record", ["station", "at"])
    op.create_index("record_of_kind", "record", ["kind", "at"])
    op.create_index("record_of_calibration", "record", ["calibration_id"])
    op.create_table(
        "file",
        sa.Column("record_key", KEY, sa.ForeignKey("record.key", ondelete="CASCADE")),
        sa.Column("path", WORDS),
        sa.Column("bytes", sa.BigInteger, nullable=False),
        sa.Column("sha256", sa.String, nullable=False),
        sa.PrimaryKeyConstraint("record_key", "path"),
    )
    op.create_table(
        "figure",
        sa.Column("record_key", KEY, sa.ForeignKey("record.key", ondelete="CASCADE")),
        sa.Column("number", sa.Integer),
        sa.Column("station", WORDS, nullable=False),
        sa.Column("at", MOMENT, nullable=False),
        sa.Column("symbol", WORDS, nullable=False),
        sa.Column("quantity", WORDS, nullable=False),
        sa.Column("value", sa.Double, nullable=False),
        sa.Column("unit", sa.String, nullable=False),
        sa.Column("expanded_uncertainty", sa.Double),
        sa.Column("limit_value", sa.Double),
        sa.Column("decision", sa.String, nullable=False),
        sa.PrimaryKeyConstraint("record_key", "number"),
    )
    op.create_index("figure_in_time", "figure", ["quantity", "station", "at"])
    op.create_index("figure_of_symbol", "figure", ["symbol", "station", "at"])
