"""Records of stations that do not exist, with results that scatter and drift."""

import hashlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta

import numpy as np

from crenel.fleet.catalogue.entry import (
    CatalogueEntry,
    EntryFigure,
    EntryFile,
    EntryKind,
    EntryVerdict,
)

START = datetime(2025, 1, 6, 6, 0, tzinfo=UTC)
PARTS = ("Housing", "Cover", "Bracket", "Flange", "Impeller", "Manifold", "Door", "Blade")
OPERATORS = ("Ada", "Ben", "Chloé", "Dmitri", "Elif", "Fatima", "Grete", "Hiro")
SPHERE = (
    ("P_Form.Sph.1x25:Ps", "form-touch", 14.0),
    ("P_Size.Sph.1x25:Ps", "size-touch", 9.0),
    ("L_Dia.5x1:Ps", "location-touch", 22.0),
    ("P_Form.Sph.D95%:Ps:ODS", "dispersion-scan", 31.0),
    ("P_Size.Sph.All:Ps:ODS", "size-all-scan", 12.0),
    ("L_Dia.2x1:Ps:ODS", "location-scan", 28.0),
)
GAUGE = (("gauge-offset", 8.0), ("gauge-z-error", 11.0), ("gauge-form", 26.0), ("gauge-rms", 7.0))
GEOMETRY = (("laser-plane-offset", 0.25, 0.002), ("probe-x", 12.0, 0.01), ("probe-z", 88.0, 0.01))
LIMIT_UM = 60.0


@dataclass(frozen=True)
class PlantedStep:
    """From a moment on, until another, the location error of a station is larger."""

    station: str
    begin: datetime
    end: datetime
    by_um: float


def invent_entries(
    stations: int,
    records: int,
    seed: int = 1,
    every: timedelta = timedelta(minutes=26),
    steps: Sequence[PlantedStep] = (),
) -> Iterator[CatalogueEntry]:
    """Records in the order of time, of each station in turn.

    Each tenth of a station is a check: most are verifications, some performance tests and
    calibrations. All others are scans with the calibration that was accepted last.

    Args:
        records: of all stations together.
        every: from one record of a station to its next.
    """
    rng = np.random.default_rng(seed)
    used = [""] * stations
    for number in range(records):
        turn, own = number % stations, number // stations
        at = START + every * own + timedelta(seconds=turn % 900)
        plain = _plain_entry(rng, f"room-{turn + 1}", at, own, used[turn])
        if own % 100 == 0:
            used[turn] = f"{plain.id}-c"
            yield _calibration(rng, replace(plain, id=used[turn], calibration_id=used[turn]))
        elif own % 50 == 20:
            yield _performance(rng, plain, steps)
        elif own % 10 == 0:
            yield _verification(rng, plain)
        else:
            yield plain


def _plain_entry(
    rng: np.random.Generator, station: str, at: datetime, own: int, calibration_id: str
) -> CatalogueEntry:
    """A scan."""
    name = f"{station} {own}"
    sizes = rng.integers(10**6, 10**9, 2)
    return CatalogueEntry(
        station=station,
        kind="scan",
        id=at.strftime("%Y%m%d-%H%M%S"),
        content=_hash(name)[:16],
        at=at,
        label=f"{PARTS[int(rng.integers(len(PARTS)))]} {int(rng.integers(1, 10**6))}",
        operator=OPERATORS[int(rng.integers(len(OPERATORS)))],
        arm_serial=f"A-{station}",
        sensor_serial=f"L-{station}",
        calibration_id=calibration_id,
        calibration_sha256=_hash(calibration_id),
        software="crenel 0.1.0",
        temperature_c=round(20.0 + float(rng.normal(0, 0.4)), 2),
        points=int(rng.integers(10**5, 10**7)),
        current_at=at + timedelta(hours=1),
        archived_at=at + timedelta(hours=1),
        place="s3://plant/" + station,
        files=(
            EntryFile("cloud.ply", int(sizes[0]), _hash(name + "cloud")),
            EntryFile("scan.mcap", int(sizes[1]), _hash(name + "scan")),
        ),
    )


def _calibration(rng: np.random.Generator, plain: CatalogueEntry) -> CatalogueEntry:
    total_um = 20.0 + float(rng.gamma(2.0, 2.0))
    figures = [_figure("point-uncertainty", total_um, LIMIT_UM)]
    figures += [
        EntryFigure(name, name, value + float(rng.normal(0, sd)), "mm")
        for name, value, sd in GEOMETRY
    ]
    return _judge(plain, "calibration", figures, "good", "calibration.json")


def _verification(rng: np.random.Generator, plain: CatalogueEntry) -> CatalogueEntry:
    figures = [
        _figure(name, um * float(rng.lognormal(0, 0.25)), LIMIT_UM, 3.0) for name, um in GAUGE
    ]
    return _judge(plain, "verification", figures, "pass", "verification.json")


def _performance(
    rng: np.random.Generator, plain: CatalogueEntry, steps: Sequence[PlantedStep]
) -> CatalogueEntry:
    more_um = sum(
        step.by_um
        for step in steps
        if step.station == plain.station and step.begin <= plain.at < step.end
    )
    figures = []
    for symbol, quantity, um in SPHERE:
        value = um + float(rng.normal(0, 2.0)) + (more_um if quantity == "location-scan" else 0.0)
        figures.append(replace(_figure(quantity, value, LIMIT_UM, 2.5), symbol=symbol))
    return _judge(plain, "performance", figures, "pass", "performance.json")


def _figure(
    quantity: str, value: float, limit: float, expanded_uncertainty: float | None = None
) -> EntryFigure:
    decision = "pass" if abs(value) <= limit else "fail"
    return EntryFigure(
        quantity, quantity, round(value, 3), "µm", expanded_uncertainty, limit, decision
    )


def _judge(
    plain: CatalogueEntry,
    kind: EntryKind,
    figures: Sequence[EntryFigure],
    good: EntryVerdict,
    document: str,
) -> CatalogueEntry:
    """The record of a check instead of a scan."""
    fails = any(one.decision == "fail" for one in figures)
    bad: EntryVerdict = "bad" if good == "good" else "fail"
    return replace(
        plain,
        kind=kind,
        label="" if kind == "calibration" else "Sphere 25",
        verdict=bad if fails else good,
        points=None,
        figures=tuple(figures),
        files=(EntryFile(document, 20_000, _hash(plain.id + document)),),
    )


def _hash(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()
