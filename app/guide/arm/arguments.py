"""What the commands of the arm's checks carry."""

from app.guide.arm.state import Kind
from app.guide.common.arguments import (
    Arguments,
    ArgumentTable,
    IdArguments,
    OperatorArguments,
)


class _Limit(Arguments):
    limit_um: float | None = None


class _Artefact(Arguments):
    kind: Kind
    size_mm: float | None = None
    standard_uncertainty_mm: float = 0.0


ARGUMENTS: ArgumentTable = {
    "choose_arm": IdArguments,
    "set_limit": _Limit,
    "choose_artefact": _Artefact,
    "run_simulation": OperatorArguments,
}
