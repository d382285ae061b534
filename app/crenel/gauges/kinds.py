"""The kinds of performance tests: one more is a folder, and a line here."""

from collections.abc import Mapping
from pathlib import Path

from crenel.gauges.contact.guide import ContactKind
from crenel.gauges.evaluate import evaluate_test, write_test
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.length.guide import LengthKind
from crenel.gauges.plan.document import Kind, read_plan
from crenel.gauges.plane.guide import PlaneKind
from crenel.gauges.session.kind import AnyKind
from crenel.gauges.sphere.guide import SphereKind

KINDS: Mapping[Kind, AnyKind] = {
    one.state.test: one for one in (SphereKind(), LengthKind(), PlaneKind(), ContactKind())
}
"""By their names."""


def evaluate_performance(folder: Path, ended_at: str = "") -> PerformanceFile:
    """Computes every figure of the test in a folder; see ``evaluate_test``."""
    return evaluate_test(folder, KINDS[read_plan(folder).kind].evaluation, ended_at)


def write_performance(folder: Path) -> PerformanceFile:
    """Evaluates the test in a folder and writes the result; see ``write_test``."""
    return write_test(folder, KINDS[read_plan(folder).kind].evaluation)
