"""Names of functions and classes: verbs or quantities, one meaning each."""

import ast
import re
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[2]
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


def modules() -> Iterator[tuple[str, ast.Module]]:
    for top in ("app", "hardware"):
        for path in sorted((ROOT / top).rglob("*.py")):
            yield path.relative_to(ROOT).as_posix(), ast.parse(path.read_text())


def functions(tree: ast.Module) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef]:
    """Those of modules and classes; properties are read like fields, and have such names."""
    nodes: list[ast.Module | ast.ClassDef] = [tree]
    nodes += [one for one in ast.walk(tree) if isinstance(one, ast.ClassDef)]
    for node in nodes:
        for child in node.body:
            if isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef) and not any(
                "property" in ast.unparse(decorator) for decorator in child.decorator_list
            ):
                yield child


def is_participle(word: str) -> bool:
    return word in IRREGULAR or REGULAR.match(word) is not None


def test_no_function_is_named_by_a_participle() -> None:
    named = [
        f"{name}:{function.lineno} {function.name}"
        for name, tree in modules()
        for function in functions(tree)
        if is_participle(function.name.strip("_").partition("_")[0])
        and function.name not in QUANTITIES
    ]
    assert not named


def test_a_class_name_has_one_meaning() -> None:
    places: dict[str, list[str]] = defaultdict(list)
    for name, tree in modules():
        for node in tree.body:
            if isinstance(node, ast.ClassDef):
                places[node.name].append(name)
    assert not {name: where for name, where in places.items() if len(where) > 1}
