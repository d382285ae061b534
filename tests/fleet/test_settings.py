"""``fleet.toml`` as docs/fleet.md shows it."""

import re
from pathlib import Path

from crenel.fleet.fleet_settings import read_fleet_settings

PAGE = (Path(__file__).parents[2] / "docs/fleet.md").read_text(encoding="utf-8")
SMALLEST, COMPLETE = re.findall(r"```toml\n(.*?)```", PAGE, re.DOTALL)


def write(folder: Path, text: str) -> Path:
    """The settings, with the files that they name beside them."""
    for name in re.findall(r'(?:_file|tls_\w+) = "([^"]+)"', text):
        (folder / name).write_text("content")
    path = folder / "fleet.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_the_smallest_settings_have_two_stations(tmp_path: Path) -> None:
    found = read_fleet_settings(write(tmp_path, SMALLEST))
    assert found.catalogue.url() == f"sqlite:///{tmp_path}/catalogue.db"
    assert [one.id for one in found.list_stations()] == ["room-1", "room-2"]


def test_the_complete_settings_are_read(tmp_path: Path) -> None:
    found = read_fleet_settings(write(tmp_path, COMPLETE))
    assert found.catalogue.url() == "postgresql://crenel:content@db.local/crenel"
    assert [one.name for one in found.list_stations()] == ["Measuring room 1", ""]
    assert found.sign_in is not None
    assert found.mqtt is not None
    assert found.server.hosts == ("fleet.example.org",)
    assert found.clouds.scheduler == "tcp://scheduler:8786"
