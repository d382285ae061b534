"""The hooks before a commit are the checks of CI."""

import re
from pathlib import Path

import yaml

ROOT = Path(__file__).parents[2]
CHECK = re.compile(r"\.venv/bin/(?:ruff|mypy)(?: [\w.-]+)*")


def test_the_hooks_run_what_ci_runs() -> None:
    config = yaml.safe_load((ROOT / ".pre-commit-config.yaml").read_text("utf-8"))
    hooks = [hook["entry"] for repo in config["repos"] for hook in repo["hooks"]]
    assert hooks == CHECK.findall((ROOT / ".ci/run").read_text("utf-8"))
