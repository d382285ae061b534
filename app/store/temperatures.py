"""The room's temperature over time, so that a calibration's can be looked up."""

from datetime import datetime, timedelta

from app.store.database import Database, utc_now

NEAR = timedelta(minutes=30)
KEPT = timedelta(days=800)


class TemperatureStore:
    """A reading every ten minutes or so, for two years."""

    def __init__(self, database: Database) -> None:
        self._database = database

    def note(self, celsius: float) -> None:
        """Keeps a reading of now, and forgets those of long ago."""
        now = utc_now()
        with self._database.writing() as connection:
            connection.execute(
                "INSERT OR REPLACE INTO temperature (at, celsius) VALUES (?, ?)", (now, celsius)
            )
            oldest = datetime.fromisoformat(now) - KEPT
            connection.execute("DELETE FROM temperature WHERE at < ?", (_text(oldest),))

    def near(self, at: str) -> float | None:
        """The reading nearest to a moment; None where there is none within half an hour."""
        moment = datetime.fromisoformat(at)
        rows = self._database.read(
            "SELECT at, celsius FROM temperature WHERE at BETWEEN ? AND ?",
            _text(moment - NEAR),
            _text(moment + NEAR),
        )
        if not rows:
            return None
        nearest = min(rows, key=lambda row: abs(datetime.fromisoformat(row["at"]) - moment))
        return float(nearest["celsius"])


def _text(moment: datetime) -> str:
    return moment.isoformat(timespec="milliseconds").replace("+00:00", "Z")
