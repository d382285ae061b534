"""Compiles the C libraries of a checkout, with only Python's standard library.

The compiler is ``$CC`` if that is set, otherwise that of the ``ziglang`` package. Each library is
one shared object that contains its code once per processor variant; ``library`` selects one.
"""

import argparse
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from crenel.native.sources import (
    FLAGS,
    LIBRARIES,
    SHARED,
    BuildTarget,
    LibrarySource,
    source_hash,
    variant_flags,
)

ZIG_TARGETS = {
    "linux": "{machine}-linux-gnu.2.17",
    "darwin": "{machine}-macos",
    "win32": "{machine}-windows-gnu",
}
WHEEL_PLATFORMS = {"linux": "manylinux_2_17_{machine}"}


class BuildError(RuntimeError):
    """A library could not be compiled."""


def build(
    source: LibrarySource,
    target: BuildTarget | None = None,
    output: Path | None = None,
    extra_flags: tuple[str, ...] = (),
    cache: Path | None = None,
) -> Path:
    """Compiles a library.

    Args:
        target: the target system; this machine by default.
        output: output file; next to its sources by default.
        extra_flags: further flags of the compiler, such as those of a sanitizer.
        cache: cache for what zig compiles for a target, three seconds' work; none by default.

    Returns:
        The shared library.

    Raises:
        BuildError: there is no compiler, or it failed; the message contains its output.
    """
    target = target or BuildTarget.here()
    output = output or source.library_path(target.system)
    compiler, zig = _compiler(target)
    with tempfile.TemporaryDirectory(prefix="crenel-build-") as folder:
        environment = (_zig_caches(cache or Path(folder)) if zig else {}) | os.environ
        common = (*compiler, *FLAGS, *extra_flags)
        code, about = str(source.folder / "c" / "library.c"), str(SHARED / "about.c")
        commands, objects = [], []
        for variant, flags in variant_flags(target).items():
            named = flags if zig else [flag.replace("x86_64_v", "x86-64-v") for flag in flags]
            objects.append(f"{folder}/{variant}.o")
            commands.append((*common, *named, f"-DVARIANT={variant}", "-c", code))
        objects.append(f"{folder}/about.o")
        commands.append((*common, f'-DSOURCES="{source_hash(source)}"', "-c", about))
        _run_all(
            [(*command, "-o", to) for command, to in zip(commands, objects, strict=True)],
            environment,
        )
        linked = f"{folder}/{output.name}"  # here, since for Windows more comes beside it
        linking = (*_link_flags(target, "-g" in extra_flags), *objects, "-o", linked, "-lm")
        _run_all([(*common, *linking)], environment)
        part = output.with_name(f"{output.name}.{os.getpid()}.part")
        shutil.copy(linked, part)
        os.replace(part, output)
    return output


def build_plain(code: Path, output: Path) -> Path:
    """Compiles one C file for this machine to a shared object that exports what it says.

    Raises:
        BuildError: there is no compiler, or it failed; the message contains its output.
    """
    compiler, zig = _compiler(BuildTarget.here())
    with tempfile.TemporaryDirectory(prefix="crenel-build-") as folder:
        environment = (_zig_caches(Path(folder)) if zig else {}) | os.environ
        command = (*compiler, *FLAGS, "-shared", str(code), "-o", str(output), "-ldl")
        _run_all([command], environment)
    return output


def wheel_tag(target: BuildTarget | None = None) -> str:
    """Tag of a wheel with the libraries: any Python 3, one platform."""
    target = target or BuildTarget.here()
    plain = f"{target.system}_{target.machine}"
    named = plain if os.environ.get("CC") else WHEEL_PLATFORMS.get(target.system, plain)
    if target.system != "linux":
        import sysconfig

        named = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"py3-none-{named.format(machine=target.machine)}"


def _compiler(target: BuildTarget) -> tuple[tuple[str, ...], bool]:
    """The compiler's command, and whether it is zig."""
    if chosen := os.environ.get("CC"):
        return tuple(shlex.split(chosen)), False
    try:
        import ziglang
    except ImportError:
        raise BuildError(
            "There is no compiler: install ziglang with pip, or name a C compiler in CC"
        ) from None
    zig = Path(ziglang.__file__).parent / ("zig.exe" if os.name == "nt" else "zig")
    # without a target, zig compiles for exactly this processor
    name = ZIG_TARGETS[target.system].format(machine=target.machine)
    return (str(zig), "cc", "-target", name), True


def _zig_caches(folder: Path) -> dict[str, str]:
    """Cache folder of zig, unless the environment sets one."""
    return {"ZIG_LOCAL_CACHE_DIR": str(folder / "zig"), "ZIG_GLOBAL_CACHE_DIR": str(folder / "zig")}


def _link_flags(target: BuildTarget, debugged: bool) -> tuple[str, ...]:
    """Flags that export the library's own functions and nothing of the compiler."""
    if target.system != "linux":
        return ("-shared",)
    exported = f"-Wl,--version-script={SHARED / 'exported.map'}"
    return ("-shared", exported) if debugged else ("-shared", exported, "-s")


def _run_all(commands: list[tuple[str, ...]], environment: dict[str, str]) -> None:
    """Runs commands in parallel.

    Raises:
        BuildError: one of them failed.
    """
    with ExitStack() as stack:
        running = [stack.enter_context(_process(command, environment)) for command in commands]
        printed = [process.communicate()[0] for process in running]
    for command, process, text in zip(commands, running, printed, strict=True):
        if process.returncode:
            raise BuildError(f"The compiler failed: {shlex.join(command)}\n{text}")
        if text.strip():
            print(text.rstrip(), file=sys.stderr)


@contextmanager
def _process(
    command: tuple[str, ...], environment: dict[str, str]
) -> Iterator[subprocess.Popen[str]]:
    """A command that runs, and does not outlive its use; raises ``BuildError``."""
    out, err = subprocess.PIPE, subprocess.STDOUT
    try:
        process = subprocess.Popen(command, env=environment, stdout=out, stderr=err, text=True)
    except OSError as error:
        raise BuildError(f"The compiler {command[0]} cannot be run: {error}") from None
    with process:
        try:
            yield process
        finally:
            process.kill()  # of one that has ended, nothing


def _parse_target(text: str) -> BuildTarget:
    """Exits if there is no such system."""
    system, _, machine = text.partition("-")
    if system not in ZIG_TARGETS or not machine:
        sys.exit(f"{text} is no target: name one of {', '.join(ZIG_TARGETS)}, and the machine")
    return BuildTarget(system, machine)


def main() -> None:
    """``python -m crenel.native.build``: compiles both libraries."""
    parser = argparse.ArgumentParser(prog="python -m crenel.native.build", description=main.__doc__)
    parser.add_argument("--target", help="such as linux-aarch64 or win32-x86_64; else this machine")
    parser.add_argument("--output", type=Path, help="a folder to write them to; else in place")
    parser.add_argument("--flags", default="", help="more flags for the compiler")
    chosen = parser.parse_args()
    target = _parse_target(chosen.target) if chosen.target else BuildTarget.here()
    for source in LIBRARIES:
        output = chosen.output / source.library_path(target.system).name if chosen.output else None
        try:
            print(build(source, target, output, tuple(shlex.split(chosen.flags))))
        except BuildError as error:
            sys.exit(str(error))


if __name__ == "__main__":
    main()
