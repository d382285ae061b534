"""The audit log names acts in words, not by the commands' own names."""

from app.guide.arm import commands as arm_commands
from app.guide.arm import rules as arm_rules
from app.guide.calibration import commands
from app.guide.calibration import rules as permissions
from app.guide.common.audit_labels import AUDIT_LABELS, audit_label
from app.guide.verify import commands as verify_commands
from app.guide.verify import rules as verify_rules


def test_every_command_of_every_flow_has_its_words() -> None:
    acts = (commands.ACTS, arm_commands.ACTS, verify_commands.ACTS)
    allowed = (permissions.ONLY_IN, arm_rules.ONLY_IN, verify_rules.ONLY_IN)
    assert {name for names in (*acts, *allowed) for name in names} == AUDIT_LABELS.keys()


def test_what_no_flow_knows_stays_as_it_was_sent() -> None:
    assert audit_label("dance") == "dance"
