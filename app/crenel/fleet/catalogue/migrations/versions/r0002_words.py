"""The words by which a record is found; those of the records that are there."""

import sqlalchemy as sa
from alembic import op

from crenel.fleet.catalogue.entry import split_words

revision = "0002"
down_revision = "0001"

KEY = sa.BigInteger().with_variant(sa.Integer, "sqlite")
WORDS = sa.String().with_variant(sa.String(collation="C"), "postgresql")
FOUND_BY = ("id", "label", "operator", "arm_serial", "sensor_serial", "object_serial")
AT_ONCE = 1000


def upgrade() -> None:
    """Adds the table and fills it."""
    word = op.create_table(
        "word",
        sa.Column("word", WORDS),
        sa.Column("at", sa.DateTime(timezone=True)),
        sa.Column("record_key", KEY, sa.ForeignKey("record.key")),
        sa.PrimaryKeyConstraint("word", "at", "record_key"),
        sqlite_with_rowid=False,
    )
    connection = op.get_bind()
    record = sa.table("record", *map(sa.column, ("key", *FOUND_BY)), sa.column("at", sa.DateTime))
    last = 0
    while rows := connection.execute(
        sa.select(record).where(record.c.key > last).order_by(record.c.key).limit(AT_ONCE)
    ).all():
        last = rows[-1].key
        op.bulk_insert(
            word,
            [
                {"word": one, "at": row.at, "record_key": row.key}
                for row in rows
                for one in sorted(split_words(" ".join(getattr(row, name) for name in FOUND_BY)))
            ],
        )
