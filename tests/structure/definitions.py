"""What the functions, classes and constants of a file use, by names that tell what it is."""

import ast
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from tests.sources import reads_tree

ASKED_BY_NAME = ("usefixtures", "getfixturevalue")


@dataclass
class Definition:
    """A function, a class or a constant at the top of a file."""

    line: int
    used: set[str] = field(default_factory=set)
    """Whole names, as far as imports tell: ``subprocess.run``, and ``Server`` of the same file; and
    ``Server.__enter__`` where it is entered."""
    fixtures: set[str] = field(default_factory=set)
    """Of a test or a fixture: names of arguments; and of fixtures that it asks for by name."""
    marks: set[str] = field(default_factory=set)


@reads_tree
def definitions(nodes: Sequence[ast.AST]) -> dict[str, Definition]:
    """Of a file, by name."""
    module = nodes[0]
    assert isinstance(module, ast.Module)
    imported = dict(_imported(nodes))
    found: dict[str, Definition] = {}
    for node in module.body:
        match node:
            case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.ClassDef():
                names = [node.name]
            case ast.Assign(targets=targets):
                names = [one.id for one in targets if isinstance(one, ast.Name)]
            case _:
                names = []
        for name in names:
            found[name] = _define(node, imported)
    return found


def _imported(nodes: Sequence[ast.AST]) -> Iterator[tuple[str, str]]:
    """The names that imports define, with what they are."""
    for node in nodes:
        match node:
            case ast.Import(names=aliases):
                for one in aliases:
                    yield (one.asname, one.name) if one.asname else (2 * (one.name.split(".")[0],))
            case ast.ImportFrom(module=str(module), names=aliases):
                yield from ((one.asname or one.name, f"{module}.{one.name}") for one in aliases)


def _define(node: ast.stmt | ast.expr, imported: dict[str, str]) -> Definition:
    found = Definition(node.lineno)
    waiting: list[ast.AST] = [node]
    while waiting:
        one = waiting.pop()
        match one:
            case ast.Name() | ast.Attribute() if (name := _dotted(one)) is not None:
                first, point, rest = name.partition(".")
                found.used.add(imported.get(first, first) + point + rest)
                if name.startswith("pytest.mark."):
                    found.marks.add(name.removeprefix("pytest.mark."))
                waiting += ast.iter_child_nodes(one)
            case ast.arg():
                pass  # an annotation uses nothing
            case ast.Call(func=ast.Attribute(attr=asking), args=given) if asking in ASKED_BY_NAME:
                found.fixtures |= {str(one.value) for one in given if isinstance(one, ast.Constant)}
                waiting += [one.func, *one.args]
            case (
                ast.withitem(context_expr=ast.Call(func=entered))
                | ast.Call(func=ast.Attribute(attr="enter_context"), args=[ast.Call(func=entered)])
            ):
                found.used |= {f"{name}.__enter__" for name in _define(entered, imported).used}
                waiting += ast.iter_child_nodes(one)
            case ast.AnnAssign(target=target, value=value):
                waiting += [target, *([value] if value else [])]
            case ast.FunctionDef() | ast.AsyncFunctionDef():
                waiting += [one.args, *one.decorator_list, *one.body]
                if one.name.startswith("test_") or any(map(_is_fixture, one.decorator_list)):
                    found.fixtures |= {arg.arg for arg in (*one.args.args, *one.args.kwonlyargs)}
            case _:
                waiting += ast.iter_child_nodes(one)
    return found


def _is_fixture(decorator: ast.expr) -> bool:
    called = decorator.func if isinstance(decorator, ast.Call) else decorator
    return _dotted(called) == "pytest.fixture"


def _dotted(node: ast.AST) -> str | None:
    """``a.b.c``, also of ``a(1).b.c``; None: it begins with something else than a name."""
    match node:
        case ast.Name(id=name):
            return name
        case ast.Attribute(value=value, attr=name):
            before = _dotted(value)
            return None if before is None else f"{before}.{name}"
        case ast.Call(func=called):
            return _dotted(called)
    return None
