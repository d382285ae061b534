"""A station under a sub-path of a real nginx, with the settings of the document and with less."""

import os
import re
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import httpx
import pytest
from playwright.sync_api import Browser, Page, ViewportSize, expect

from crenel.formats.clouds.files import read_cloud
from tests.api.conftest import until
from tests.bench.station.subprocess_station import free_port
from tests.e2e.conftest import ROOT, Demo, wait_in_page
from tests.e2e.test_demo import calibrate
from tests.e2e.visit import Visit
from tests.present import present

pytestmark = [pytest.mark.device, pytest.mark.soak]

NGINX = shutil.which("nginx") or shutil.which("nginx", path="/usr/sbin:/usr/local/sbin")
DOCUMENT = ROOT / "docs" / "proxy.md"
SIZE: ViewportSize = {"width": 1280, "height": 800}
FRAME = """
daemon off; master_process off; pid {folder}/pid; error_log {folder}/error.log;
events {{}}
http {{
    access_log off;
    client_body_temp_path {folder}/body; proxy_temp_path {folder}/proxy;
    fastcgi_temp_path {folder}/f; uwsgi_temp_path {folder}/u; scgi_temp_path {folder}/s;
    {limits}
    server {{ listen 127.0.0.1:{port};
    {locations}
    }}
}}
"""


def block(name: str) -> str:
    """Settings in the document."""
    found = re.search(rf"```nginx {name}\n(.*?)```", DOCUMENT.read_text(), re.DOTALL)
    return present(found)[1]


def location(sub_path: str, station: str, without: str = "(?!)", kept: bool = False) -> str:
    """The document's settings of a sub-path.

    Args:
        station: the address of the station, without a slash at its end.
        without: lines with this are left out.
        kept: the sub-path is passed on.
    """
    lines = block("sub-path").replace("/crenel", sub_path)
    lines = lines.replace("http://127.0.0.1:8000/", station if kept else f"{station}/")
    return "\n".join(line for line in lines.splitlines() if not re.search(without, line))


@contextmanager
def nginx(folder: Path, *locations: str) -> Iterator[str]:
    """Its address while it runs."""
    if NGINX is None:
        if os.environ.get("CI"):
            pytest.fail("nginx is not installed, and CI must run these tests")
        pytest.skip("nginx is not installed")
    port, config = free_port(), folder / "nginx.conf"
    config.write_text(
        FRAME.format(
            folder=folder, port=port, limits=block("limits"), locations="\n".join(locations)
        )
    )
    with subprocess.Popen([NGINX, "-p", str(folder), "-c", str(config)]) as running:
        try:
            until(lambda: running.poll() is not None or _answers(port))
            assert running.poll() is None, (folder / "error.log").read_text()
            yield f"http://127.0.0.1:{port}"
        finally:
            running.terminate()


def _answers(port: int) -> bool:
    try:
        return httpx.get(f"http://127.0.0.1:{port}/").status_code == 404
    except httpx.TransportError:
        return False


@dataclass(frozen=True)
class Plant:
    """A station behind nginx, under several sub-paths."""

    station: Demo
    address: str

    def link(self, sub_path: str) -> str:
        """The console's link, as a browser in front of the proxy opens it."""
        return f"{self.address}{sub_path}/#{self.station.link.partition('#')[2]}"


@pytest.fixture
def station(tmp_path: Path) -> Iterator[Demo]:
    """A station that lists this machine as a proxy."""
    data = tmp_path / "data"
    data.mkdir()
    (data / "station.toml").write_text('[station]\nproxies = ["127.0.0.1"]\n')
    running = Demo(data, ("tests.e2e.quick_station", str(data), "--width", "640"))
    yield running
    running.end()


def test_a_station_works_under_a_sub_path(
    station: Demo, browser: Browser, screenshots: Path | None, pictures: Path, tmp_path: Path
) -> None:
    address = station.address.rstrip("/")
    with nginx(
        tmp_path, location("/crenel", address), location("/room-2", address, kept=True)
    ) as proxy:
        plant = Plant(station, proxy)
        page = browser.new_page(viewport=SIZE)
        visit = Visit(page, screenshots, "/crenel")
        page.goto(plant.link("/crenel"))
        page.get_by_role("button", name="Calibrate").click()
        page.get_by_role("button", name="Start calibration").click()
        calibrate(visit)
        scan(visit, tmp_path)
        look_at_a_report(page, plant.address)
        look_at_the_view(page, pictures / "proxy-scan.png")
        cookies = {one.get("path") for one in page.context.cookies()}
        assert cookies == {"/crenel/"}
        assert not visit.faults, "\n".join(visit.faults)
        page.close()

        kept = browser.new_page(viewport=SIZE)
        visit = Visit(kept, screenshots, "/room-2")
        kept.goto(plant.link("/room-2"))
        kept.get_by_role("link", name="Scan").click()
        look_at_the_view(kept, pictures / "proxy-kept.png")
        assert not visit.faults, "\n".join(visit.faults)
        kept.close()
    assert station.end() in (0, 130)
    assert not station.complaints, "".join(station.complaints)


def scan(visit: Visit, folder: Path) -> None:
    """A scan, and its cloud as it is downloaded."""
    page = visit.page
    page.get_by_role("link", name="Scan").click()
    page.get_by_role("button", name="Start scan").click()
    page.get_by_role("button", name="Let the simulated operator do it").click()
    visit.wait_until("scanning", "/api/scan", lambda scan: scan["points"] > 10_000)
    # it is always there, also after a scan that ended while the page was drawn
    page.get_by_role("button", name="STOP", exact=True).click()
    visit.wait_until("stopping", "/api/scan", lambda scan: scan["state"] == "idle")
    page.get_by_role("link", name="Records").click()
    with page.expect_download() as download:
        page.get_by_role("link", name=re.compile("PLY")).first.click()
    saved = folder / "cloud.ply"
    download.value.save_as(saved)
    assert len(read_cloud(saved).points_mm) > 10_000


def look_at_a_report(page: Page, address: str) -> None:
    """Its link, and a page below a page, which is loaded again."""
    page.get_by_role("button", name="Open").first.click()
    with page.expect_popup() as opened:
        page.get_by_role("link", name="Report", exact=True).click()
    expect(opened.value.get_by_role("heading", name="Calibration report")).to_be_visible()
    opened.value.close()
    assert page.url.startswith(f"{address}/crenel/records/")
    page.reload()
    expect(page.get_by_text("In use.")).to_be_visible()


def look_at_the_view(page: Page, picture: Path) -> None:
    """The cloud is drawn in its frame."""
    page.get_by_role("link", name="Scan").click()
    wait_in_page(
        page,
        """() => {
          const frame = document.querySelector('iframe[data-ready]');
          return frame?.contentDocument?.querySelector('canvas') != null;
        }""",
    )
    # drawn without a graphics processor, it held everything up
    expect(page.get_by_text("Connection lost")).to_be_hidden()
    page.screenshot(path=picture, timeout=120_000)


def test_what_the_proxy_does_not_pass_on_is_said(
    station: Demo, browser: Browser, pictures: Path, tmp_path: Path
) -> None:
    address = station.address.rstrip("/")
    with nginx(
        tmp_path,
        location("/hostless", address, "Host"),
        location("/still", address, "Upgrade|Connection"),
        location("/silent", address, "Prefix"),
        location("/lost", address, "Prefix", kept=True),
    ) as proxy:
        plant = Plant(station, proxy)
        for sub_path, said, remedy in (
            ("/hostless", "A proxy changes the Host of requests", "Host $http_host"),
            ("/still", "no live connection opens", "Upgrade $http_upgrade"),
            ("/silent", "does not know that it is offered under /silent/", "root_path = "),
            ("/lost", "The files of this page do not arrive", "root_path"),
        ):
            page = browser.new_page(viewport=SIZE)
            page.goto(plant.link(sub_path))
            expect(page.get_by_text(said)).to_be_visible()
            expect(page.get_by_text(remedy).first).to_be_visible()
            page.screenshot(path=pictures / f"proxy{sub_path.replace('/', '-')}.png")
            page.set_viewport_size({"width": 820, "height": 1180})
            page.screenshot(path=pictures / f"proxy{sub_path.replace('/', '-')}-820.png")
            page.close()
    assert station.end() in (0, 130)
    logged = "".join(station.errors)
    assert logged.count("a proxy does not pass on WebSockets") == 1
    assert logged.count("let it pass on the browser's Host") == 1
