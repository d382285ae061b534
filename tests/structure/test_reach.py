"""Which tests a change reaches, on the project as it is."""

import os
from collections.abc import Callable
from pathlib import Path, PurePath

import pytest

from tests.running import reach
from tests.running.imports import files_of_text, known_files, used_files
from tests.running.marks import Cost, read_marks
from tests.running.reach import (
    OF_ALL_FILES,
    base_commit,
    changed_files,
    git,
    reached_tests,
    text_at,
)
from tests.sources import READS_TREE, ROOT, name_of

pytestmark = READS_TREE

ENGLISH = "app/crenel/store/en.ftl"


def reach_of(*changed: str) -> reach.Reach:
    return reached_tests(changed, lambda name: "")


def reached(*changed: str) -> set[str]:
    """Files of tests reached by changes of code, without those that look at every file."""
    found = reach_of(*changed)
    assert not found.all_by
    return {name for name in found.tests if not name.startswith(OF_ALL_FILES)}


def folders(names: set[str]) -> set[str]:
    return {PurePath(name).parts[1] for name in names}


def test_a_module_reaches_the_tests_that_import_it_themselves_or_by_others() -> None:
    found = reached("hardware/crenel_hardware/arm/microscribe/microscribe.py")
    assert "tests/hardware/test_microscribe.py" in found
    assert "tests/metrology/test_frames.py" not in found
    found = reached("app/crenel/metrology/transforms.py")
    assert {"metrology", "station", "api"} <= folders(found)
    assert "tests/hardware/test_microscribe.py" not in found


def test_imports_within_functions_and_the_packages_of_modules_count() -> None:
    program = "app/crenel"
    assert f"{program}/gauges/quick/clouds/evaluate_repeatability.py" in used_files(
        ROOT / program / "cli/scan.py"
    )
    stripe = f"{program}/metrology/stripe"
    assert f"{stripe}/__init__.py" in used_files(ROOT / stripe / "bands.py")


def test_a_public_name_counts_where_it_is_asked_for() -> None:
    assert used_files(ROOT / "app/crenel/errors.py") >= {"app/crenel/__init__.py"}
    assert used_files(ROOT / "app/crenel/__init__.py") == frozenset()
    assert "app/crenel/public.py" in used_files(ROOT / "docs/examples/extract_stripe.py")


def test_a_module_reaches_the_tests_that_start_it() -> None:
    assert {"e2e", "api", "cli"} <= folders(reached("app/crenel/server/startup.py"))
    assert "tests/supervision/test_broker.py" in reached("tests/supervision/publishing.py")
    assert "tests/batch/test_scheduler_address.py" in reached("app/crenel/cli/batch.py")
    assert "tests/docs/test_examples.py" in reach_of("docs/examples/write_a_driver.py").tests


def test_a_text_names_modules_that_it_imports_and_files() -> None:
    folder = ROOT / "tests/hardware"

    def named(text: str) -> set[str]:
        return {file for file in files_of_text(text, folder) if not file.endswith("__init__.py")}

    assert named("crenel_hardware.arm.serial_encoder:from_options") == {
        "hardware/crenel_hardware/arm/serial_encoder.py"
    }
    assert named("import os\nfrom crenel.cli import (\n    main,\n    scan)\n") == {
        "app/crenel/cli/main.py",
        "app/crenel/cli/scan.py",
    }
    assert named("ros2_publisher.py") == {"tests/hardware/ros2_publisher.py"}
    assert named("app/crenel/cli/main.py") == {"app/crenel/cli/main.py"}
    assert not named("An arm and a sensor. The app.")


@pytest.mark.parametrize(
    "name",
    [
        *(".ci/run", "app/crenel/native/c/stripe/fit.c", "docker/Dockerfile"),
        *("frontend/package.json", "hardware/firmware/avr/Makefile", "pyproject.toml"),
        *("tests/api/conftest.py", "tests/unknown.bin"),
    ],
)
def test_what_can_change_anything_reaches_all(name: str) -> None:
    found = reach_of("docs/formats.md", name)
    assert found.all_by == name
    assert set(found.tests) == {name_of(path) for path in ROOT.glob("tests/**/test_*.py")}


def test_a_page_reaches_the_tests_that_read_it() -> None:
    assert "tests/docs/test_formats.py" in reach_of("docs/formats.md").tests
    assert not reached("docs/glossary.md", "LICENSE", "frontend/screenshots/review.png")


def test_the_browsers_part_and_data_files_reach_their_tests() -> None:
    assert folders(reached("frontend/src/main.tsx")) == {"e2e", "frontend"}
    assert folders(reached("tests/fleet/revision_1.sql")) == {"fleet"}


def test_a_message_reaches_the_tests_of_what_uses_it() -> None:
    text = (ROOT / ENGLISH).read_text("utf-8")

    def reached_after(before: str) -> reach.Reach:
        return reached_tests([ENGLISH], lambda name: before)

    begin = text.index("\nstations-disk-full =") + 1
    found = reached_after(text[:begin] + "stations-disk-full = Full.\n" + text[begin + 1 :])
    assert not found.all_by
    assert "tests/store/test_full_disk.py" in found.tests
    assert "tests/metrology/test_frames.py" not in found.tests
    # one more was there, whose users have changed with it
    gone = reached_after(f"{text}\nno-such-message = Gone.\n")
    assert all(name.startswith(OF_ALL_FILES) for name in gone.tests)
    # what a new file has is used
    assert {"tests/store/test_full_disk.py"} <= set(reached_after("").tests)


def test_a_deleted_module_reaches_what_changed_with_it() -> None:
    assert not reached("app/crenel/metrology/deleted.py")
    # modules of a package whose own file is deleted are others, though none of them has changed
    modules = {name for name in known_files() if name.startswith("tests/store/test_")}
    assert reached("tests/store/__init__.py") >= modules


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str, float], str]:
    """A repository; called with a text and hours, it commits the text as of so long ago."""
    monkeypatch.setattr(reach, "ROOT", tmp_path)
    for name in os.environ.keys() & {"GIT_DIR", "GIT_INDEX_FILE", "GIT_WORK_TREE"}:
        monkeypatch.delenv(name)
    for person in ("AUTHOR", "COMMITTER"):
        monkeypatch.setenv(f"GIT_{person}_NAME", "A tester")
        monkeypatch.setenv(f"GIT_{person}_EMAIL", "tester@example.org")
    git("init", "-q")

    def commit(text: str, hours_ago: float) -> str:
        (tmp_path / "file.txt").write_text(text)
        monkeypatch.setenv("GIT_COMMITTER_DATE", f"@{round(2e9 - 3600 * hours_ago)} +0000")
        git("add", ".")
        git("commit", "-q", "-m", text)
        return git("rev-parse", "HEAD").strip()

    return commit


def test_changes_begin_a_day_before(project: Callable[[str, float], str], tmp_path: Path) -> None:
    project("first", 80)
    assert base_commit() == ""
    second = project("second", 40)
    (tmp_path / "deleted.txt").write_text("there")
    project("third", 20)
    project("fourth", 2)
    assert base_commit() == second
    assert base_commit("HEAD~1") == git("rev-parse", "HEAD~3").strip()
    (tmp_path / "deleted.txt").unlink()
    (tmp_path / "new name.txt").write_text("not yet known")
    assert changed_files("HEAD~1") == ["deleted.txt", "file.txt", "new name.txt"]
    assert text_at(second)("file.txt") == "second"
    assert text_at(second)("deleted.txt") == ""


def test_the_command_prints_the_soak_tests_that_are_reached(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(reach, "base_commit", lambda: "0123456789")
    monkeypatch.setattr(reach, "changed_files", lambda base: ["app/new.bin"])
    reach.main()
    printed = capsys.readouterr()
    soak = printed.out.splitlines()
    assert soak
    assert all(Cost.SOAK in read_marks(ROOT / name).of_some for name in soak)
    count = f"{len(soak)} of {len(soak)} files with soak tests are reached"
    assert printed.err == f"1 files changed since 01234567; {count}, all by app/new.bin\n"
    monkeypatch.setattr(reach, "changed_files", lambda base: ["docs/glossary.md"])
    reach.main()
    assert not capsys.readouterr().out


def test_without_a_commit_a_day_older_all_are_reached(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(reach, "base_commit", lambda: "")
    reach.main()
    assert capsys.readouterr().err.startswith("No commit is a day older; ")
