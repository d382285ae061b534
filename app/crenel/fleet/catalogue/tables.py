"""The tables of the catalogue, the same in SQLite and PostgreSQL."""

from datetime import UTC, datetime
from typing import Any, ClassVar

from sqlalchemy import (
    BigInteger,
    DateTime,
    Dialect,
    Double,
    ForeignKey,
    Index,
    Integer,
    String,
    TypeDecorator,
    UniqueConstraint,
)
from sqlalchemy.orm import DeclarativeBase, Mapped, mapped_column

KEY = BigInteger().with_variant(Integer, "sqlite")
"""SQLite numbers rows only in its own kind of integer."""
WORDS = String().with_variant(String(collation="C"), "postgresql")
"""Compared byte by byte, as SQLite does: a range of such texts is a prefix."""


class UtcMoment(TypeDecorator[datetime]):
    """A time with its zone; SQLite has none and keeps UTC."""

    impl = DateTime(timezone=True)
    cache_ok = True

    def process_bind_param(self, value: datetime | None, dialect: Dialect) -> datetime | None:
        if value is None:
            return None
        moment = value.astimezone(UTC)
        return moment.replace(tzinfo=None) if dialect.name == "sqlite" else moment

    def process_result_value(self, value: Any | None, dialect: Dialect) -> datetime | None:
        if value is None:
            return None
        found: datetime = value
        return found.replace(tzinfo=UTC) if found.tzinfo is None else found.astimezone(UTC)


class CatalogueTable(DeclarativeBase):
    """All tables."""

    type_annotation_map: ClassVar[dict[type, object]] = {float: Double()}


class StationRow(CatalogueTable):
    """A station that was collected from."""

    __tablename__ = "station"

    id: Mapped[str] = mapped_column(WORDS, primary_key=True)
    name: Mapped[str]
    collected_at: Mapped[datetime | None] = mapped_column(UtcMoment)
    """The last time that everything it offered was in the catalogue."""
    problem: Mapped[str] = mapped_column(default="")
    """Why the last attempt failed; empty if it did not."""
    records: Mapped[int] = mapped_column(BigInteger, default=0, server_default="0")
    """This and the next are kept with every change: counting would read all records."""
    archived: Mapped[int] = mapped_column(BigInteger, default=0, server_default="0")
    size_bytes: Mapped[int] = mapped_column(BigInteger, default=0, server_default="0")
    newest_at: Mapped[datetime | None] = mapped_column(UtcMoment)


class RecordRow(CatalogueTable):
    """One record; its fields are those of ``CatalogueEntry``."""

    __tablename__ = "record"
    __table_args__ = (
        UniqueConstraint("station", "kind", "id", name="one_record"),
        Index("record_in_time", "at"),
        Index("record_of_station", "station", "at"),
        Index("record_of_kind", "kind", "at"),
        Index("record_of_calibration", "calibration_id"),
    )

    key: Mapped[int] = mapped_column(KEY, primary_key=True, autoincrement=True)
    station: Mapped[str] = mapped_column(WORDS, ForeignKey("station.id"))
    kind: Mapped[str] = mapped_column(WORDS)
    id: Mapped[str] = mapped_column(WORDS)
    content: Mapped[str]
    at: Mapped[datetime] = mapped_column(UtcMoment)
    label: Mapped[str]
    operator: Mapped[str]
    simulated: Mapped[bool]
    arm_serial: Mapped[str]
    sensor_serial: Mapped[str]
    object_serial: Mapped[str]
    calibration_id: Mapped[str] = mapped_column(WORDS)
    calibration_sha256: Mapped[str]
    arm_sha256: Mapped[str]
    software: Mapped[str]
    verdict: Mapped[str]
    temperature_c: Mapped[float | None]
    points: Mapped[int | None] = mapped_column(BigInteger)
    current_at: Mapped[datetime] = mapped_column(UtcMoment)
    archived_at: Mapped[datetime | None] = mapped_column(UtcMoment)
    place: Mapped[str]
    size_bytes: Mapped[int] = mapped_column(BigInteger)


class FileRow(CatalogueTable):
    """A file of a record."""

    __tablename__ = "file"

    record_key: Mapped[int] = mapped_column(
        KEY, ForeignKey("record.key", ondelete="CASCADE"), primary_key=True
    )
    path: Mapped[str] = mapped_column(WORDS, primary_key=True)
    bytes: Mapped[int] = mapped_column(BigInteger)
    sha256: Mapped[str]


class FigureRow(CatalogueTable):
    """A result of a record. Station and time stand here, too: a drift reads this table only."""

    __tablename__ = "figure"
    __table_args__ = (
        Index("figure_in_time", "quantity", "station", "at"),
        Index("figure_of_symbol", "symbol", "station", "at"),
    )

    record_key: Mapped[int] = mapped_column(
        KEY, ForeignKey("record.key", ondelete="CASCADE"), primary_key=True
    )
    number: Mapped[int] = mapped_column(primary_key=True)
    """Within the record."""
    station: Mapped[str] = mapped_column(WORDS)
    at: Mapped[datetime] = mapped_column(UtcMoment)
    symbol: Mapped[str] = mapped_column(WORDS)
    quantity: Mapped[str] = mapped_column(WORDS)
    value: Mapped[float]
    unit: Mapped[str]
    expanded_uncertainty: Mapped[float | None]
    limit_value: Mapped[float | None]
    """``limit`` is a word of SQL."""
    decision: Mapped[str]


class WordRow(CatalogueTable):
    """A word by which a record is found; time and key stand in the order of an answer."""

    __tablename__ = "word"
    __table_args__ = ({"sqlite_with_rowid": False},)

    word: Mapped[str] = mapped_column(WORDS, primary_key=True)
    at: Mapped[datetime] = mapped_column(UtcMoment, primary_key=True)
    record_key: Mapped[int] = mapped_column(KEY, ForeignKey("record.key"), primary_key=True)
