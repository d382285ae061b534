"""The gauges of a data folder, from their certificates."""

from pathlib import Path

from app.errors import OperationError
from app.findings import Finding
from app.formats.datasheets.gauge import GaugeFile, read_gauge
from app.formats.file_names import check_name
from app.guide.verify.live import Gauges
from app.messages.message import message

SUFFIXES = (".nominal.json", ".json")


def read_gauges(folder: Path) -> Gauges:
    """Reads ``*.json`` of a folder; the id is the file's name without its endings."""
    known: dict[str, GaugeFile] = {}
    findings: list[Finding] = []
    for path in sorted(folder.glob("*.json")):
        try:
            check_name(path)
            known.setdefault(_gauge_id(path), read_gauge(path))
        except OperationError as error:
            findings.append(Finding("attention", error.text, message("correct-remove-file")))
    return Gauges(known, tuple(findings))


def _gauge_id(path: Path) -> str:
    return next(path.name.removesuffix(end) for end in SUFFIXES if path.name.endswith(end))


def gauge_path(folder: Path, gauge: str) -> Path:
    """The file of a gauge by its id."""
    return next(path for path in sorted(folder.glob("*.json")) if _gauge_id(path) == gauge)
