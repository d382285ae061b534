"""Builds docker/Dockerfile and starts what it makes, without a daemon or a registry of images.

``python3 .ci/container.py`` as root on Debian. The base image is made of Debian's packages, by
this machine's apt; ``--base NAME`` takes a published one instead. The image must be healthy within
ten seconds of its start, not run as root, and hold no compiler.
"""

import argparse
import ast
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
NAME = "localhost/crenel"
TOOLS = ("buildah", "mmdebstrap", "unshare", "nsenter", "ip")
PACKAGES = ("buildah", "mmdebstrap", "util-linux", "iproute2")
AUTHORITIES = "/etc/ssl/certs/ca-certificates.crt"
HEALTHY_WITHIN_S = 10.0
PATIENCE_S = 240.0
"""A station that is healthy late is told with its time."""
COMPILERS = ("cc", "gcc", "g++", "clang", "zig", "node", "npm")
STATION = """\
[station]
name = "Container"

[arm]
driver = "serial-encoder"
url = "socket://127.0.0.1:9"

[sensor]
driver = "folder"
path = "pictures"
"""


class ContainerError(Exception):
    """The image cannot be built, or is not what it should be."""


def output_of(*command: str) -> str:
    """What a command prints; its errors go where this script's go.

    Raises:
        ContainerError: it failed.
    """
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode:
        raise ContainerError(f"{' '.join(command)} ended with {done.returncode}")
    return done.stdout.strip()


class Builder:
    """``buildah`` with a store of its own in a folder, and without a daemon."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.command = ["buildah", "--storage-driver", "vfs"]
        self.command += ["--root", str(folder / "store"), "--runroot", str(folder / "run")]

    def do(self, *arguments: str) -> str:
        return output_of(*self.command, *arguments)

    def size_mb(self, image: str) -> float:
        """Of all layers of an image."""
        (about,) = json.loads(self.do("images", "--json", image))
        number, unit = about["size"].split()
        return float(number) * {"KB": 1e-3, "MB": 1.0, "GB": 1e3}[unit]

    def debian(self) -> str:
        """A base image of this machine's own release: Debian with Python."""
        name, archive = f"{NAME}-base", str(self.folder / "base.tar")
        index = ("apt-get", "indextargets", "--format", "$(REPO_URI) $(RELEASE)")
        mirror, suite = output_of(*index, "Created-By: Packages").splitlines()[0].split()
        wanted = ("--variant=minbase", "--include=python3,python3-venv")
        output_of("mmdebstrap", "--quiet", *wanted, suite, archive, mirror)
        container = self.do("from", "scratch")
        self.do("add", "--quiet", container, archive, "/")
        self.do("commit", "--quiet", "--rm", container, name)
        os.unlink(archive)
        return name

    def build(self, base: str) -> None:
        """Builds the station's image, lending it this machine's settings of pip and npm."""
        lent = {"/etc/pip.conf": self.folder / "pip.conf", "/root/.npmrc": self.folder / "npmrc"}
        lent["/etc/pip.conf"].write_text(pip_settings())
        lent["/root/.npmrc"].write_text(npm_settings())
        if Path(AUTHORITIES).is_file():
            lent[AUTHORITIES] = Path(AUTHORITIES)
        volumes = [f"--volume={here}:{there}:ro" for there, here in lent.items()]
        # only this format keeps the health check
        how = ("--isolation=chroot", "--format=docker", f"--build-arg=BASE={base}")
        file = f"--file={ROOT / 'docker/Dockerfile'}"
        self.do("build", "--quiet", *how, *volumes, f"--tag={NAME}", file, str(ROOT))


def pip_settings() -> str:
    """pip's settings of this machine, of its files and its environment, as one file.

    Folders of this machine are left out: they are not there in the build.
    """
    listed = subprocess.run(
        [sys.executable, "-m", "pip", "config", "list"], capture_output=True, text=True, check=False
    ).stdout
    lines = ["[global]"]
    for line in listed.splitlines():
        name, _, value = line.partition("=")
        kept = [w for w in ast.literal_eval(value).split() if not w.startswith(("/", "file:"))]
        if kept:
            lines.append(f"{name.rpartition('.')[2]} = {' '.join(kept)}")
    if Path(AUTHORITIES).is_file():
        lines.append(f"cert = {AUTHORITIES}")
    return "\n".join([*lines, ""])


def npm_settings() -> str:
    """npm's settings of this machine, with its certificate authorities."""
    own = Path.home() / ".npmrc"
    lines = own.read_text().splitlines() if own.is_file() else []
    kept = [line for line in lines if not line.startswith(("cafile", "nodedir"))]
    return "\n".join([*kept, f"cafile={AUTHORITIES}" if Path(AUTHORITIES).is_file() else "", ""])


class Network:
    """A network of its own, with nothing but the loopback address."""

    def __enter__(self) -> list[str]:
        self.keeper = subprocess.Popen(["unshare", "--net", "sleep", "infinity"])
        time.sleep(0.5)
        inside = ["nsenter", f"--net=/proc/{self.keeper.pid}/ns/net"]
        output_of(*inside, "ip", "link", "set", "lo", "up")
        return inside

    def __exit__(self, *raised: object) -> None:
        self.keeper.kill()
        self.keeper.wait()


def check_contents(builder: Builder, run: list[str]) -> None:
    """It does not run as root, and no compiler is left.

    Raises:
        ContainerError: it is not so.
    """
    user = output_of(*run, "id", "-u")
    if user == "0":
        raise ContainerError("the container runs as root")
    wanted = " ".join(COMPILERS)
    found = output_of(*run, "sh", "-c", f"for name in {wanted}; do command -v $name; done; true")
    if found:
        raise ContainerError(f"compilers are left in the image: {found.split()}")
    print(f"  user {output_of(*run, 'id')}; no compiler", flush=True)


def check_start(builder: Builder, container: str, run: list[str]) -> None:
    """Its own command is started, and its own health check asked until it says yes.

    Raises:
        ContainerError: the station ends, or is healthy too late.
    """
    config = json.loads(builder.do("inspect", container))["Docker"]["config"]
    log = builder.folder / "station.log"
    began = time.monotonic()
    with (
        log.open("w") as said,
        subprocess.Popen(
            [*run, *config["Entrypoint"], *config["Cmd"]], stdout=said, stderr=said
        ) as station,
    ):
        try:
            kind, *health = config["Healthcheck"]["Test"]
            assert kind == "CMD"
            while subprocess.run([*run, *health], stderr=subprocess.DEVNULL).returncode:
                if station.poll() is not None:
                    raise ContainerError(f"the station ended\n{log.read_text()}")
                if time.monotonic() - began > PATIENCE_S:
                    raise ContainerError(f"not healthy after {PATIENCE_S:.0f} s\n{log.read_text()}")
                time.sleep(0.2)
            seconds = time.monotonic() - began
        finally:
            station.terminate()
    print(f"  healthy after {seconds:.1f} s", flush=True)
    if seconds > HEALTHY_WITHIN_S:
        raise ContainerError(f"healthy after {seconds:.1f} s, not {HEALTHY_WITHIN_S:.0f}")


def check(builder: Builder, base: str) -> None:
    """Builds, starts and checks the image.

    Raises:
        ContainerError: it is not what it should be.
    """
    began = time.monotonic()
    base = base or builder.debian()
    builder.build(base)
    print(f"  built in {time.monotonic() - began:.0f} s", flush=True)
    whole, below = builder.size_mb(NAME), builder.size_mb(base)
    print(f"  {whole:.0f} MB, of which the base image {below:.0f} MB", flush=True)
    container = builder.do("from", NAME)
    station = builder.folder / "station"
    (station / "pictures").mkdir(parents=True)
    (station / "station.toml").write_text(STATION)
    builder.do("copy", "--quiet", "--chown=1000:1000", container, str(station), "/data")
    with Network() as inside:
        run = [*inside, *builder.command, "run", "--isolation=chroot", container]
        check_contents(builder, run)
        check_start(builder, container, run)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--base", default="", help="a published base image, such as python:3.13")
    base = parser.parse_args().base
    if not all(map(shutil.which, TOOLS)):
        output_of("apt-get", "update", "-q")
        output_of("apt-get", "install", "-y", "-q", "--no-install-recommends", *PACKAGES)
    folder = Path(tempfile.mkdtemp(prefix="crenel-container-"))
    try:
        check(Builder(folder), base)
    except ContainerError as error:
        sys.exit(f"container: {error}")
    finally:
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    main()
