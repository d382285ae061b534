"""Names of functions and classes: verbs or quantities, one meaning each."""

import ast
import re
from collections import defaultdict
from collections.abc import Sequence

from tests.sources import PROGRAM, name_of, python_files, reads_tree

IRREGULAR = frozenset(
    (
        *("told", "said", "seen", "held", "known", "shown", "drawn", "given", "taken", "made"),
        *("kept", "found", "left", "lost", "sent", "got", "met", "begun", "done", "gone"),
        *("written", "chosen", "broken", "worn", "driven", "hidden", "thrown", "grown", "bound"),
        *("bent", "built", "dealt", "felt", "heard", "hung", "laid", "led", "lent", "spent"),
        *("stood", "struck", "swept", "taught", "thought", "won"),
    )
)
REGULAR = re.compile(r"^(?!need|seed|feed|speed|exceed|embed|proceed|succeed|shed)\w+ed$")
QUANTITIES = frozenset(
    # an adjective before its noun, or with the noun "quantity" left out
    ("bound_adjustment", "saturated_rms_px", "signed", "rounded")
)


@reads_tree
def functions(nodes: Sequence[ast.AST]) -> list[tuple[int, str]]:
    """Line and name of those of modules and classes.

    Properties are read like fields, and have such names.
    """
    return [
        (child.lineno, child.name)
        for node in nodes
        if isinstance(node, ast.Module | ast.ClassDef)
        for child in node.body
        if isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef)
        and not any("property" in ast.unparse(decorator) for decorator in child.decorator_list)
    ]


@reads_tree
def classes(nodes: Sequence[ast.AST]) -> list[str]:
    """The names of a module's classes."""
    module = nodes[0]
    assert isinstance(module, ast.Module)
    return [node.name for node in module.body if isinstance(node, ast.ClassDef)]


def is_participle(word: str) -> bool:
    return word in IRREGULAR or REGULAR.match(word) is not None


def test_no_function_is_named_by_a_participle() -> None:
    named = [
        f"{name_of(path)}:{line} {name}"
        for path in python_files(*PROGRAM)
        for line, name in functions(path)
        if is_participle(name.strip("_").partition("_")[0]) and name not in QUANTITIES
    ]
    assert not named


def test_a_class_name_has_one_meaning() -> None:
    places: dict[str, list[str]] = defaultdict(list)
    for path in python_files(*PROGRAM):
        for name in classes(path):
            places[name].append(name_of(path))
    assert not {name: where for name, where in places.items() if len(where) > 1}
