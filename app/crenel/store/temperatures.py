"""The temperatures at the station, entered by a user or measured by a thermometer."""

from dataclasses import dataclass
from datetime import timedelta

from crenel.store.database import Database
from crenel.timestamps import is_moment, parse_moment, utc_now

NEAR = timedelta(hours=3)
"""A reading is not valid for times further away than this."""


@dataclass(frozen=True, slots=True)
class TemperatureReading:
    """One temperature."""

    at: str
    celsius: float
    source: str


class TemperatureStore:
    """Temperature readings; they are only added."""

    def __init__(self, database: Database) -> None:
        self._database = database

    def add(self, celsius: float, source: str) -> TemperatureReading:
        reading = TemperatureReading(utc_now(), celsius, source)
        with self._database.transaction() as connection:
            connection.execute(
                "INSERT INTO temperature (at, celsius, source) VALUES (?, ?, ?)",
                (reading.at, reading.celsius, reading.source),
            )
        return reading

    def near(self, at: str) -> TemperatureReading | None:
        """The reading nearest to a time (ISO 8601), if one is near enough."""
        before = self._read("at <= ? ORDER BY at DESC LIMIT 1", at)
        after = self._read("at > ? ORDER BY at LIMIT 1", at)
        moment, readings = parse_moment(at), before + after
        found = [(abs(parse_moment(r.at) - moment), r) for r in readings if is_moment(r.at)]
        best = min(found, key=lambda pair: pair[0], default=None)
        return best[1] if best is not None and best[0] <= NEAR else None

    def change_since(self, at: str) -> float | None:
        """Temperature change in °C until now; None if one of the two temperatures is unknown."""
        now, then = self.newest(), self.near(at)
        if now is None or then is None or now.at == then.at:
            return None  # a single reading shows no change
        return now.celsius - then.celsius

    def celsius_near(self, at: str) -> float | None:
        """The temperature at a time, if known."""
        reading = self.near(at)
        return None if reading is None else reading.celsius

    def newest(self) -> TemperatureReading | None:
        """The last reading, unless it is too old for the present temperature."""
        return self.near(utc_now())

    def _read(self, clause: str, at: str) -> list[TemperatureReading]:
        return [
            TemperatureReading(row["at"], row["celsius"], row["source"])
            for row in self._database.read(
                f"SELECT at, celsius, source FROM temperature WHERE {clause}", at
            )
        ]
