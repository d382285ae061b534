"""The decision rule that a record was judged by, as its file has it, and in words."""

from dataclasses import asdict

from crenel.formats.json_document import DocumentPart, NotNegative
from crenel.messages.message import Text, join, message, rounded
from crenel.metrology.decision import EXPANDED_K2, GUARDED_95, SIMPLE, Bearer, DecisionRule


class RulePart(DocumentPart):
    """How values, their uncertainties and their limits became decisions."""

    name: str = GUARDED_95.name
    standard: str = GUARDED_95.standard
    edition: str = GUARDED_95.edition
    guard_factor: NotNegative = GUARDED_95.guard_factor
    """The guard band in standard uncertainties; 0: simple acceptance."""
    bearer: Bearer = "prover"

    @classmethod
    def of(cls, rule: DecisionRule) -> "RulePart":
        """The part that records a rule."""
        return cls.model_validate(asdict(rule))

    @property
    def rule(self) -> DecisionRule:
        """The rule that it records."""
        return DecisionRule(**self.model_dump())


FORMER_CHECK_RULE = RulePart.of(EXPANDED_K2)
"""What verifications and tip checks were judged by before they stated their rule."""
FORMER_ARM_RULE = RulePart.of(SIMPLE)
"""The same for arm checks."""
FORMER_POINT_RULE = RulePart.of(GUARDED_95)
"""The same for the features of calibration reports."""


def describe_rule(rule: RulePart) -> Text:
    """Name, standard and edition of a rule, its guard band, and who bears the uncertainty."""
    named = message(
        "decision-rule-named", name=rule.name, standard=rule.standard, edition=rule.edition
    )
    if rule.guard_factor == 0:
        return join([named, message("decision-rule-without-guard")], " ")
    factor = rounded(rule.guard_factor)
    return join([named, message("decision-rule-guard", factor=factor, bearer=rule.bearer)], " ")
