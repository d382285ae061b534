"""Names of earlier versions, in requests and journals, are still understood."""

import pytest

from crenel.guide.arm import state as arm
from crenel.guide.calibration import state as calibration
from crenel.guide.common.journal import FORMER_NOTES, SIMULATION_NOTES
from crenel.guide.verify import state as verify
from crenel.server.middleware import FORMER_PATHS, present_path
from crenel.wire.schema import FORMER_COMMANDS, FlowCommand


@pytest.mark.parametrize(("former", "present"), FORMER_COMMANDS.items())
def test_a_command_is_understood_by_its_former_name(former: str, present: str) -> None:
    assert FlowCommand(name=former, args={}, rev=0, key="k").name == present
    assert FlowCommand(name=present, args={}, rev=0, key="k").name == present


def test_a_path_is_replaced_whole_or_at_its_beginning() -> None:
    assert present_path("/api/walls") == "/api/kiosk-links"
    assert present_path("/api/walls/7") == "/api/kiosk-links/7"
    assert present_path("/api/wallspace") == "/api/wallspace"
    assert not set(FORMER_PATHS) & set(FORMER_PATHS.values())


@pytest.mark.parametrize("note", FORMER_NOTES)
def test_a_journal_of_an_earlier_version_is_read(note: str) -> None:
    assert note in SIMULATION_NOTES
    assert note in calibration.NOTES
    assert note in arm.CHANGES
    assert note in verify.CHANGES
