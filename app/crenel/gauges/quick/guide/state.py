"""The state of a verification: a fold over its journal. Pure."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import ClassVar

from crenel.gauges.session.changes import Payload, apply_change, restore_touch, void_touch
from crenel.guide.common.journal import SIMULATION_NOTES, JournalEntry, reading_of

STEPS = ("gauge", "touch", "scan", "review")


@dataclass(frozen=True)
class GaugeContact:
    """One contact on the gauge."""

    index: int
    gauge: str
    """The one chosen then; for another it does not count."""
    reading: tuple[float, ...]
    """The arm's."""
    voided: bool = False


@dataclass(frozen=True)
class VerificationCloud:
    """One pass over the gauge, recorded in the folder of its name."""

    number: int
    gauge: str
    at: str
    """When it was begun."""
    ended: bool = False
    fit: Payload | None = None
    refused: Payload | None = None
    """Why it is of no use."""
    seconds: float = 0.0
    voided: bool = False

    @property
    def name(self) -> str:
        """The name of its folder."""
        return f"cloud-{self.number}"

    @property
    def waiting(self) -> bool:
        """Whether it is still to be measured."""
        return self.ended and self.fit is None and self.refused is None and not self.voided


@dataclass(frozen=True)
class VerifyState:
    """Where a verification stands."""

    all_steps: ClassVar[tuple[str, ...]] = STEPS
    session_id: str = ""
    rev: int = 0
    started_at: str = ""
    calibration_id: str = ""
    step: str = "gauge"
    reached: str = "gauge"
    gauge: str = ""
    """The gauge of the data folder, by the name of its file."""
    by_probe: bool = False
    """Whether scans are compared with the touches."""
    touches: tuple[GaugeContact, ...] = ()
    undone: tuple[int, ...] = ()
    """Touches that were taken back since the last one was taken; they can be put back."""
    clouds: tuple[VerificationCloud, ...] = ()
    ended: str = ""
    """accepted or abandoned; empty while the session is open."""

    @property
    def counted(self) -> tuple[GaugeContact, ...]:
        """Touches that count."""
        return tuple(t for t in self.touches if not t.voided and t.gauge == self.gauge)

    @property
    def listed(self) -> tuple[VerificationCloud, ...]:
        """Clouds of the chosen gauge, those set aside too."""
        return tuple(cloud for cloud in self.clouds if cloud.gauge == self.gauge)

    @property
    def good(self) -> tuple[VerificationCloud, ...]:
        """Clouds that are judged."""
        return tuple(c for c in self.listed if c.fit is not None and not c.voided)

    @property
    def open_cloud(self) -> VerificationCloud | None:
        """The one that is being scanned."""
        last = self.clouds[-1] if self.clouds else None
        return last if last is not None and not last.ended and not last.voided else None


def apply_row(state: VerifyState, row: JournalEntry) -> VerifyState:
    """The state after one more row of the journal.

    Raises:
        ValueError: a row of a kind that this version does not know.
    """
    return apply_change(CHANGES, state, row)


def _start(state: VerifyState, payload: Payload) -> VerifyState:
    return replace(
        state,
        calibration_id=payload["calibration_id"],
        gauge=payload["gauge"],
        started_at=payload["at"],
    )


def _add_touch(state: VerifyState, payload: Payload) -> VerifyState:
    touch = GaugeContact(len(state.touches), state.gauge, reading_of(payload))
    return replace(state, touches=(*state.touches, touch), undone=())


def _touch_voided(state: VerifyState, payload: Payload) -> VerifyState:
    index = payload["index"]
    if all(t.index != index for t in state.counted):
        return state
    return void_touch(state, payload)


def _cloud_begun(state: VerifyState, payload: Payload) -> VerifyState:
    cloud = VerificationCloud(payload["number"], state.gauge, payload["at"])
    return replace(state, clouds=(*state.clouds, cloud))


def _with_cloud(**fields: str) -> Callable[[VerifyState, Payload], VerifyState]:
    """Changes fields of the cloud of a number, to what the payload has under these names."""

    def change(state: VerifyState, payload: Payload) -> VerifyState:
        changes = {field: payload[name] for field, name in fields.items()}
        clouds = (
            replace(c, **changes) if c.number == payload["number"] else c for c in state.clouds
        )
        return replace(state, clouds=tuple(clouds))

    return change


CHANGES: dict[str, Callable[[VerifyState, Payload], VerifyState]] = {
    "started": _start,
    "gauge_chosen": lambda state, payload: replace(state, gauge=payload["id"], undone=()),
    "gauge_confirmed": lambda state, payload: replace(state, step="touch"),
    "touched": _add_touch,
    "touch_voided": _touch_voided,
    "touch_restored": restore_touch,
    "touch_confirmed": lambda state, payload: replace(state, step="scan", by_probe=True),
    "touch_skipped": lambda state, payload: replace(state, step="scan", by_probe=False),
    "cloud_begun": _cloud_begun,
    "cloud_ended": _with_cloud(ended="ended"),
    "cloud_measured": _with_cloud(fit="fit", seconds="seconds"),
    "cloud_refused": _with_cloud(refused="refused"),
    "cloud_voided": _with_cloud(voided="voided", ended="voided"),
    "cloud_restored": _with_cloud(voided="voided"),
    "clouds_confirmed": lambda state, payload: replace(state, step="review"),
    "went_back": lambda state, payload: replace(state, step=payload["to"]),
    **dict.fromkeys(SIMULATION_NOTES, lambda state, payload: state),
    "accepted": lambda state, payload: replace(state, ended="accepted"),
    "abandoned": lambda state, payload: replace(state, ended="abandoned"),
}
