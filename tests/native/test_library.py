"""A library that is missing, stale or not for this processor is said to be so."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from crenel.native.build import BuildError, build
from crenel.native.library import CRENEL, VARIANT_SETTING, NativeLibrary
from crenel.native.sources import LIBRARIES, LibraryError, LibrarySource, source_hash


def copied(folder: Path) -> LibrarySource:
    """The product's library, with its sources, elsewhere."""
    source = LIBRARIES[0]
    shutil.copytree(source.folder / "c", folder / "c")
    shutil.copy(source.library_path(), folder)
    return LibrarySource(source.name, folder)


def test_a_missing_library_is_named_with_the_command_that_builds_it(tmp_path: Path) -> None:
    with pytest.raises(LibraryError, match=r"is not built\. Build it: python -m"):
        _ = NativeLibrary(LibrarySource("crenel", tmp_path)).variants


def test_a_library_older_than_its_sources_is_refused(tmp_path: Path) -> None:
    source = copied(tmp_path)
    assert NativeLibrary(source).variants == CRENEL.variants
    header = tmp_path / "c" / "export.h"
    header.write_text(header.read_text() + "/* changed */\n")
    with pytest.raises(LibraryError, match="is older than its C sources"):
        _ = NativeLibrary(source).variants


def test_an_installed_library_without_sources_is_used(tmp_path: Path) -> None:
    source = copied(tmp_path)
    shutil.rmtree(tmp_path / "c")
    assert NativeLibrary(source).variants == CRENEL.variants


def test_the_hash_distinguishes_files(tmp_path: Path) -> None:
    (tmp_path / "c").mkdir()
    (tmp_path / "c" / "one.c").write_text("int one;")
    before = source_hash(LibrarySource("some", tmp_path))
    (tmp_path / "c" / "one.c").rename(tmp_path / "c" / "two.c")
    assert source_hash(LibrarySource("some", tmp_path)) != before


def report_variant(variant: str) -> subprocess.CompletedProcess[str]:
    script = "from crenel.native.library import CRENEL; print(CRENEL.variant)"
    environment = os.environ | {VARIANT_SETTING: variant}
    command = [sys.executable, "-c", script]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)


@pytest.mark.device
def test_an_unknown_variant_is_refused_with_those_that_run() -> None:
    assert report_variant("v1").stdout == "v1\n"
    refused = report_variant("v9")
    assert refused.returncode
    assert "The variant v9 does not run on this processor" in refused.stderr
    assert "one of: v1" in refused.stderr


def test_a_compiler_that_fails_is_quoted(tmp_path: Path) -> None:
    source = copied(tmp_path)
    (tmp_path / "c" / "library.c").write_text("this is not C")
    with pytest.raises(BuildError, match=r"The compiler failed: (.|\n)*error:"):
        build(source)
