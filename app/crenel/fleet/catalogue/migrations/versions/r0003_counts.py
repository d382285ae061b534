"""Counts of each station's records, kept with every change; those of the records that are there."""

import sqlalchemy as sa
from alembic import op

revision = "0003"
down_revision = "0002"

COUNTS = ("records", "archived", "size_bytes")


def upgrade() -> None:
    """Adds the columns and fills them."""
    for name in COUNTS:
        op.add_column("station", sa.Column(name, sa.BigInteger, nullable=False, server_default="0"))
    op.add_column("station", sa.Column("newest_at", sa.DateTime(timezone=True)))
    record = sa.table("record", *map(sa.column, ("station", "archived_at", "size_bytes", "at")))
    station = sa.table("station", *map(sa.column, ("id", *COUNTS, "newest_at")))

    def of_station(value: sa.ColumnElement[int]) -> sa.ScalarSelect[int]:
        return sa.select(value).where(record.c.station == station.c.id).scalar_subquery()

    op.execute(
        sa.update(station).values(
            records=of_station(sa.func.count()),
            archived=of_station(sa.func.count(record.c.archived_at)),
            size_bytes=of_station(sa.func.coalesce(sa.func.sum(record.c.size_bytes), 0)),
            newest_at=of_station(sa.func.max(record.c.at)),
        )
    )
