"""Collects the words that the code says to people, for translators: the keys of the files here.

The English sentence is the key, where an f-string's fields are places in braces. Of Python what
is no docstring, no log line, no statement of a database and no name of the program's own is
taken; of TypeScript what is given to ``t``, ``counted`` and ``words``.
"""

import ast
import re
from collections.abc import Iterator
from itertools import islice, product
from pathlib import Path

from app.strings.words import WORDS

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = (
    *(f"app/{package}" for package in ("api", "formats", "guide", "metrology", "monitoring")),
    *(
        f"app/{package}"
        for package in ("operations", "report", "security", "station", "store", "supervision")
    ),
    *("app/wire", "app/workflows", "hardware"),
    *("app/server/middleware.py", "app/server/starting_page.py"),
)
EXCLUDED = (
    *("app/api/metrics.py", "app/server/composition.py", "app/api/support.py"),
    *("hardware/arm/protocol.py", "hardware/simulator", "app/formats/recording/blocks.py"),
    *("app/formats/recording/wire_format.py", "app/formats/recording/raw.py"),
    # what only the console says
    *(
        f"app/formats/clouds/{name}.py"
        for name in ("e57", "las", "optional_library", "pcd", "rows", "xyz")
    ),
    *(
        "app/formats/clouds/ply.py",
        "app/workflows/identify_arm.py",
        "app/workflows/extract_stripes.py",
        "app/workflows/verify_gauge.py",
    ),
    "app/formats/session/arm_session.py",
)
"""Files of these rooms whose words are for machines."""
MOST_FORMS = 16
"""Of one f-string with choices in it."""

_LETTERS = re.compile(r"[^\W\d_]{2}")
_PROGRAM = re.compile(
    r"[<>\\@#$]|^\S*_\S*$|::|=\"|filename|\w ?= ?\?|\.\w{2,4}$|^\S*://\S*$|^/|[;:]$"
    r"|[A-Z]+ (TABLE|INTO|FROM|OR|INDEX|BY)\b|^(WHERE|id,) "
    r"|^\W*(SELECT|INSERT|UPDATE|DELETE|PRAGMA|CREATE|BEGIN|ALTER)\b|^\w+/|charset|must-reval"
    r"|repeat\(|^(VERSION|FIELDS|SIZE|TYPE|COUNT|WIDTH|HEIGHT|VIEWPOINT|POINTS|DATA)\b"
    r"|^(element|property) |-src |frame-anc|max-age|no-store"
)
_SENTENCE = re.compile(
    r"^(?:.*[^\W\d_]{2}.* .*|.* .*[^\W\d_]{2}.*|[A-Z][a-z]+(?:-[a-z]+)?[.:]?)$", re.S
)
_UNITS = re.compile(r"\b(mm|µm|nm|px|rms|ms|ns|rad|deg|GB|MB|UTC)\b")
_PLACE = re.compile(r"\{\w+\}")
_QUIET_CALLS = re.compile(r"^(log|logger|logging|re|warnings|struct|np|numpy|cv2|os|mimetypes)$")
_FUNCTIONS = (
    "execute executemany executescript getattr setdefault encode replace split strip partition "
    "rpartition removeprefix removesuffix startswith endswith joinpath strftime astype cast "
    "TypeVar NewType Literal Path Query Field compile kernel getLogger import_module AssertionError"
)
_QUIET_FUNCTIONS = frozenset(_FUNCTIONS.split())
_QUIET_KEYWORDS = frozenset(("description", "name", "pattern", "dtype", "tags", "alias", "mode"))


def collect_texts(root: Path = ROOT) -> list[str]:
    """Every text, sorted."""
    found: set[str] = set()
    for room in PACKAGES:
        place = root / room
        for path in [place] if place.is_file() else sorted(place.rglob("*.py")):
            if not path.relative_to(root).as_posix().startswith(EXCLUDED):
                found.update(python_texts(path.read_text(encoding="utf-8")))
    found.update(WORDS)
    for path in sorted((root / "frontend" / "src").rglob("*.ts*")):
        found.update(typescript_texts(path.read_text(encoding="utf-8")))
    return sorted(found)


def python_texts(source: str) -> Iterator[str]:
    """What one module says."""
    speech = _TextCollector()
    speech.visit(ast.parse(source))
    # what only goes on with a sentence is looked up without what joins it
    texts = (text.strip(" ,;·") for text in speech.texts)
    yield from (text for text in texts if is_user_text(text))


def is_user_text(text: str) -> bool:
    """Whether it is for people: words beside the places, and not the program's own."""
    rest = _UNITS.sub("", _PLACE.sub("", text))
    if not _LETTERS.search(rest) or _PROGRAM.search(rest):
        return False
    return bool(_SENTENCE.match(text))


class _TextCollector(ast.NodeVisitor):
    def __init__(self) -> None:
        self.texts: list[str] = []

    def visit_Expr(self, node: ast.Expr) -> None:
        if not isinstance(node.value, ast.Constant):  # a docstring
            self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> None:
        if isinstance(node.value, str):
            self.texts.append(node.value)

    def visit_JoinedStr(self, node: ast.JoinedStr) -> None:
        self.texts.extend(template_forms(node))
        for part in node.values:
            if isinstance(part, ast.FormattedValue):
                # the words that are chosen between are part of the forms
                for value in _choices(part.value):
                    if not isinstance(value, str):
                        self.visit(value)

    def visit_IfExp(self, node: ast.IfExp) -> None:
        for part in (node.body, node.orelse):
            self.visit(part)

    def visit_Dict(self, node: ast.Dict) -> None:
        for value in node.values:
            self.visit(value)

    def visit_Assign(self, node: ast.Assign) -> None:
        names = {target.id for target in node.targets if isinstance(target, ast.Name)}
        if "__all__" not in names:
            self.generic_visit(node)

    def visit_Compare(self, node: ast.Compare) -> None:
        pass

    def visit_Assert(self, node: ast.Assert) -> None:
        pass

    def visit_Subscript(self, node: ast.Subscript) -> None:
        self.visit(node.value)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        if node.value is not None:
            self.visit(node.value)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        for value in (*node.args.defaults, *node.args.kw_defaults, *node.body):
            if value is not None:
                self.visit(value)

    def visit_arg(self, node: ast.arg) -> None:
        pass

    def visit_Call(self, node: ast.Call) -> None:
        function = node.func
        if isinstance(function, ast.Attribute):
            owner = function.value
            if isinstance(owner, ast.Name) and _QUIET_CALLS.match(owner.id):
                return
            self.visit(owner)
        name = function.attr if isinstance(function, ast.Attribute) else ""
        name = function.id if isinstance(function, ast.Name) else name
        if name in _QUIET_FUNCTIONS:
            return
        for argument in node.args:
            self.visit(argument)
        for keyword in node.keywords:
            if keyword.arg not in _QUIET_KEYWORDS:
                self.visit(keyword.value)


def template_forms(node: ast.JoinedStr) -> Iterator[str]:
    """The templates of an f-string: one for each of the choices between fixed words in it."""
    parts = [_part(part) for part in node.values]
    for chosen in islice(product(*parts), MOST_FORMS):
        names: dict[str, int] = {}
        text = ""
        for part in chosen:
            if isinstance(part, str):
                text += part
                continue
            name = placeholder_name(part)
            names[name] = names.get(name, 0) + 1
            text += f"{{{name}{names[name] if names[name] > 1 else ''}}}"
        yield text


def _part(part: ast.expr) -> list[str | ast.expr]:
    if isinstance(part, ast.Constant):
        return [str(part.value).replace("{", "").replace("}", "")]
    assert isinstance(part, ast.FormattedValue)
    return list(_choices(part.value))


def _choices(value: ast.expr) -> Iterator[str | ast.expr]:
    if isinstance(value, ast.IfExp) and (_is_fixed(value.body) or _is_fixed(value.orelse)):
        yield from _choices(value.body)
        yield from _choices(value.orelse)
    elif isinstance(value, ast.Constant) and isinstance(value.value, str):
        yield value.value
    else:
        yield value


def _is_fixed(value: ast.expr) -> bool:
    return isinstance(value, ast.Constant) and isinstance(value.value, str)


def placeholder_name(value: ast.expr) -> str:
    """What a place is called: after the expression, where that has a name."""
    match value:
        case ast.Name():
            return value.id
        case ast.Attribute():
            return value.attr
        case ast.Call(func=ast.Name(id="display_path" | "display_backup")):
            return placeholder_name(value.args[0])
        case ast.Call(func=ast.Name(id="len" | "abs" | "round" | "max" | "min" | "sum" | "float")):
            return placeholder_name(value.args[0]) if value.args else "value"
        case ast.Call():
            return placeholder_name(value.func)
        case ast.Subscript() | ast.Starred():
            return placeholder_name(value.value)
        case ast.BinOp():
            names = (placeholder_name(value.left), placeholder_name(value.right))
            return next((name for name in names if name != "value"), "value")
        case ast.UnaryOp():
            return placeholder_name(value.operand)
    return "value"


_TEXT = r"\"((?:[^\"\\]|\\.)*)\"|`([^`$\\]*)`"
_TEXT_CALL = re.compile(rf"\b(?:t|words)\(\s*(?:{_TEXT})")
_PLURAL_CALL = re.compile(
    rf"\bcounted\((?:[^()\"`]|\([^()]*\))+?,\s*(?:{_TEXT}),\s*(?:{_TEXT})", re.S
)


def typescript_texts(source: str) -> Iterator[str]:
    """What is given to ``t``, ``words`` and ``counted``."""
    for match in (*_TEXT_CALL.finditer(source), *_PLURAL_CALL.finditer(source)):
        for text in match.groups():
            if text:
                yield text.replace('\\"', '"').replace("\\u00a0", "\u00a0")
