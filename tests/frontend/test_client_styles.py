"""The classes that components of the client name are in their CSS modules."""

import re
from pathlib import Path

from tests.frontend.node import FRONTEND

IMPORT = re.compile(r'import (\w+) from "(\.[^"]+\.module\.css)"')


def unknown_classes(component: Path) -> list[str]:
    """The classes in a component that their CSS module does not have."""
    text = component.read_text("utf-8")
    found = []
    for name, address in IMPORT.findall(text):
        css = (component.parent / address).read_text("utf-8")
        known = set(re.findall(r"\.([A-Za-z]\w*)", css))
        used = set(re.findall(rf"\b{name}\.(\w+)", text))
        found += [f"{component.name}: {name}.{one}" for one in sorted(used - known)]
    return found


def test_every_class_is_in_its_css_module() -> None:
    components = sorted((FRONTEND / "src").rglob("*.tsx"))
    assert len(components) > 100
    assert not [one for component in components for one in unknown_classes(component)]


def test_an_unknown_class_is_found(tmp_path: Path) -> None:
    (tmp_path / "a.module.css").write_text(".row { color: red }")
    component = tmp_path / "A.tsx"
    component.write_text('import styles from "./a.module.css";\nstyles.row; styles.column;')
    assert unknown_classes(component) == ["A.tsx: styles.column"]
