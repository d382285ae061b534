"""The audit log names acts in words, not by the commands' own names."""

from typing import Any

import pytest

from crenel.gauges.guide_commands import COMMANDS as OF_PERFORMANCE
from crenel.gauges.guide_rules import RULES as PERFORMANCE_RULES
from crenel.gauges.quick.guide.commands import COMMANDS as OF_VERIFICATION
from crenel.gauges.quick.guide.rules import RULES as VERIFICATION_RULES
from crenel.guide.arm.commands import COMMANDS as OF_ARM
from crenel.guide.arm.rules import RULES as ARM_RULES
from crenel.guide.calibration.commands import COMMANDS as OF_CALIBRATION
from crenel.guide.calibration.rules import RULES as CALIBRATION_RULES
from crenel.guide.common.audit_labels import AUDIT_LABELS, audit_label
from crenel.guide.common.commands import Commands
from crenel.guide.common.rules import CommandRules
from crenel.parts.session.commands import COMMANDS as OF_PARTS
from crenel.parts.session.rules import RULES as PART_RULES

FLOWS: tuple[tuple[Commands[Any], CommandRules[Any, Any]], ...] = (
    (OF_CALIBRATION, CALIBRATION_RULES),
    (OF_ARM, ARM_RULES),
    (OF_VERIFICATION, VERIFICATION_RULES),
    (OF_PERFORMANCE, PERFORMANCE_RULES),
    (OF_PARTS, PART_RULES),
)


@pytest.mark.parametrize(("commands", "rules"), FLOWS)
def test_acts_are_those_with_rules(commands: Commands[Any], rules: CommandRules[Any, Any]) -> None:
    assert commands.acts.keys() == rules.commands.keys()
    assert commands.at_press.keys() <= commands.acts.keys()


def test_every_command_of_every_flow_has_its_words() -> None:
    assert {name for _, rules in FLOWS for name in rules.commands} == AUDIT_LABELS.keys()


def test_what_no_flow_knows_stays_as_it_was_sent() -> None:
    assert audit_label("dance") == "dance"
