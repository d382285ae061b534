"""The run over all kinds of faults goes on where one cannot be tried."""

from pathlib import Path

import pytest

from crenel.errors import OperationError
from tests.bench.faults import calls, disk, everything
from tests.bench.faults.everything import FaultKind
from tests.bench.faults.row import FaultRow

pytestmark = pytest.mark.device

DISK = FaultKind("disk", lambda data, seed, report: [disk.run(data, seed=seed, progress=report)])
OTHER = FaultKind("other", lambda data, seed, report: [FaultRow("other", 1, 1)])


@pytest.fixture(autouse=True)
def installed_copy(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """The C source of the preloaded library is in a checkout alone."""
    monkeypatch.setattr(calls, "CODE", tmp_path / "none.c")
    monkeypatch.setattr(everything, "KINDS", (DISK, OTHER))


def test_a_kind_that_cannot_be_tried_has_a_row_that_says_so() -> None:
    untried, tried = everything.run([])
    assert (untried.kind, untried.tries) == ("disk", 0)
    assert "checkout of the sources" in untried.notes[0]
    assert tried == FaultRow("other", 1, 1)


def test_the_only_one_that_cannot_be_tried_is_an_error_as_is_an_unknown_one() -> None:
    with pytest.raises(OperationError) as raised:
        everything.run(["disk"])
    assert raised.value.code == calls.UNAVAILABLE
    with pytest.raises(OperationError, match="there are: disk, other"):
        everything.run(["discs"])
