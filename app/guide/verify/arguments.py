"""What the commands of the guided verification carry."""

from app.guide.common.arguments import (
    ArgumentTable,
    BackArguments,
    IdArguments,
    IndexArguments,
    NumberArguments,
    OperatorArguments,
)

ARGUMENTS: ArgumentTable = {
    "choose_gauge": IdArguments,
    "void_touch": IndexArguments,
    "void_cloud": NumberArguments,
    "restore_cloud": NumberArguments,
    "back": BackArguments,
    "run_simulation": OperatorArguments,
}
