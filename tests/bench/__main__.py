"""``python -m tests.bench NAME``, in a checkout: every benchmark by its name.

A name is one of the commands of ``tests.bench.commands``, or a module of this folder that can be
run: ``outlier-contacts`` is ``tests/bench/outlier_contacts.py``. Without a name, all are listed.
"""

import ast
import runpy
import sys
from pathlib import Path

from tests.bench.commands import bench

FOLDER = Path(__file__).parent


def modules() -> dict[str, Path]:
    """The modules here that can be run, by the names that the command line has for them."""
    names = {path.stem: path for path in FOLDER.glob("*.py") if path.stem[:2] != "__"}
    names |= {path.parent.name: path for path in FOLDER.glob("*/__main__.py")}
    return {
        name.replace("_", "-"): path
        for name, path in sorted(names.items())
        if '\nif __name__ == "__main__":' in path.read_text("utf-8")
    }


def subject(path: Path) -> str:
    """The first line of a module's docstring."""
    return (ast.get_docstring(ast.parse(path.read_text("utf-8"))) or "").partition("\n")[0]


def main() -> None:
    given, found = sys.argv[1:2], modules()
    if given and given[0] in found:
        place = found[given[0]].relative_to(FOLDER).with_suffix("")
        module = ".".join(("tests.bench", *place.parts)).removesuffix(".__main__")
        sys.argv[:2] = [f"python -m tests.bench {given[0]}"]
        runpy.run_module(module, run_name="__main__", alter_sys=False)
        return
    if given in ([], ["--help"], ["-h"]):
        print("Modules, each with a --help of its own:")
        for name, path in found.items():
            print(f"  {name:22}{subject(path)}")
    bench(prog_name="python -m tests.bench")


if __name__ == "__main__":
    main()
