"""The *Fleet* page in a browser, with a catalogue of three stations."""

import re
from collections.abc import Iterator
from datetime import timedelta
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, Route, expect

pytest.importorskip("sqlalchemy")
pytest.importorskip("psycopg")

from crenel.archive.ownership import MARKER
from crenel.fleet.catalogue.catalogue import FleetCatalogue
from tests.bench.fleet.invented import START, PlantedStep, invent_entries
from tests.bench.station.subprocess_station import free_port
from tests.fleet import test_clouds as clouds
from tests.fleet.test_server import running_fleet
from tests.fleet.test_sign_in import write_settings
from tests.single_sign_on.mock_provider import mock_provider

pytestmark = [pytest.mark.device, pytest.mark.soak]
WRONG_SINCE = START + timedelta(days=120)
SEARCHES = "**/api/fleet/records?*"
STEP = PlantedStep("room-2", WRONG_SINCE, WRONG_SINCE + timedelta(days=30), 14.0)


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    folder = tmp_path_factory.mktemp("fleet")
    with FleetCatalogue(f"sqlite:///{folder}/catalogue.db") as catalogue:
        catalogue.add(list(invent_entries(3, 6000, 1, timedelta(hours=3.6), [STEP])))
        catalogue.note_collection("room-1", "Room one", START)
    archive = folder / "room-2"  # empty
    archive.mkdir()
    (archive / MARKER).touch()
    settings = folder / "fleet.toml"
    settings.write_text(
        '[catalogue]\ndatabase = "sqlite:///catalogue.db"\n'
        '[stations.room-2]\narchive = { url = "room-2" }\n'
        f'[mqtt]\nhost = "127.0.0.1"\nport = {free_port()}\n'  # nobody listens
    )
    with running_fleet(settings) as client:
        yield str(client.base_url)


@pytest.fixture
def page(browser: Browser, address: str) -> Iterator[Page]:
    opened = browser.new_page(viewport={"width": 1280, "height": 800})
    opened.goto(f"{address}?lang=en")
    yield opened
    opened.close()


def open_view(page: Page, name: str) -> None:
    page.get_by_role("group", name="View").get_by_role("button", name=name).click()


def open_first(page: Page, text: str) -> None:
    """Opens the first record of the list as soon as it has a text: that of the search before stays
    until the answer is there."""
    row = page.locator("tbody tr").first
    expect(row).to_contain_text(text)
    row.get_by_role("button").click()


def test_stations_and_records(page: Page) -> None:
    expect(page.get_by_role("heading", name="room-2")).to_be_visible()
    expect(page.locator("dd").filter(has_text="2000").first).to_be_visible()
    expect(page.get_by_text("The broker cannot be reached")).to_be_visible()
    expect(page.get_by_text("Not heard")).to_have_count(0)
    open_view(page, "Records")
    rows = page.locator("tbody tr")
    expect(rows).to_have_count(51)
    page.get_by_role("button", name="Show 50 more").click()
    expect(rows).to_have_count(101)
    page.locator("select").last.select_option("performance")
    page.locator("select").first.select_option("room-2")
    expect(rows.first).to_contain_text("Sphere 25")
    rows.first.get_by_role("button").click()
    expect(page.get_by_text("L_Dia.2x1:Ps:ODS")).to_be_visible()
    page.get_by_role("button", name="Back to the list").click()
    page.get_by_label("Part, operator").fill("nothing like this")
    expect(page.get_by_text("No record is found.")).to_be_visible()


def test_a_row_of_records_fits_and_names_its_station(page: Page, pictures: Path) -> None:
    expect(page.get_by_role("heading", name="Room one")).to_be_visible()
    expect(page.get_by_text(re.compile(r"^Times: .*(UTC|Etc)"))).to_be_visible()
    open_view(page, "Records")
    page.locator("select").first.select_option("room-1")
    row = page.locator("tbody tr").first
    expect(row).to_contain_text("Room one")
    for width in (1280, 1024, 820):
        page.set_viewport_size({"width": width, "height": 800})
        table = page.get_by_role("table")
        fits = table.evaluate("table => table.offsetWidth <= table.parentElement.clientWidth")
        page.screenshot(path=pictures / f"fleet-records-{width}.png")
        assert fits, width
    page.locator("select").nth(1).select_option("scan")
    row.get_by_role("button").click()
    expect(page.get_by_text(re.compile("^crenel rebuild '.*--format copc"))).to_be_visible()
    expect(page.get_by_text("Room one")).to_be_visible()
    page.screenshot(path=pictures / "fleet-record-1024.png")


def test_days_in_the_wrong_order_are_explained(page: Page, pictures: Path) -> None:
    open_view(page, "Records")
    day = START.date().isoformat()
    page.get_by_label("From").fill((START + timedelta(days=2)).date().isoformat())
    page.get_by_label("Until").fill(day)
    expect(page.get_by_role("alert")).to_have_text(re.compile("^From is after Until"))
    expect(page.get_by_role("table")).to_have_count(0)
    for width in (1280, 820):
        page.set_viewport_size({"width": width, "height": 800})
        page.screenshot(path=pictures / f"fleet-days-{width}.png")
        assert page.evaluate("document.documentElement.scrollWidth") == width
    page.get_by_label("From").fill(day)
    expect(page.get_by_role("alert")).to_have_count(0)
    expect(page.locator("tbody tr").first).to_contain_text("room-")
    page.get_by_role("button", name="Deutsch").click()
    page.get_by_role("button", name="Datensätze").click()
    page.get_by_label("Von").fill("2026-05-02")
    page.get_by_label("Bis").fill("2026-05-01")
    expect(page.get_by_role("alert")).to_contain_text("„Von“ liegt nach „Bis“")
    page.screenshot(path=pictures / "fleet-days-820-de.png")


def test_a_search_that_takes_long_shows_it_and_is_tried_again(page: Page, pictures: Path) -> None:
    held: list[Route] = []
    open_view(page, "Records")
    rows, listed = page.locator("tbody tr"), page.locator("tbody")
    expect(rows).to_have_count(51)
    page.route(SEARCHES, lambda route: held.append(route))
    with page.expect_request(SEARCHES):
        page.get_by_label("Part, operator").fill("Sphere")
    expect(listed).to_have_attribute("aria-busy", "true")
    expect(page.get_by_text("Searching…")).to_be_visible()
    expect(rows.nth(1)).to_have_css("opacity", "0.4")
    for width in (1280, 820):
        page.set_viewport_size({"width": width, "height": 800})
        page.screenshot(path=pictures / f"fleet-searching-{width}.png")
        assert page.evaluate("document.documentElement.scrollWidth") == width
    held.pop().abort()
    page.unroute(SEARCHES)
    expect(listed).to_have_attribute("aria-busy", "false")
    expect(page.get_by_text("Searching…")).to_have_count(0)
    expect(rows.first).to_contain_text("Sphere")
    expect(rows.first).to_have_css("opacity", "1")


def test_a_cloud_is_made_and_downloaded(browser: Browser, tmp_path: Path, pictures: Path) -> None:
    clouds.fill_room(tmp_path, of_two=True)
    settings = clouds.write_settings(tmp_path, 'archive = { url = "plant/room-2" }')
    with clouds.collected(settings) as client:
        page = browser.new_page(viewport={"width": 1280, "height": 800})
        page.goto(f"{client.base_url}?lang=en")
        open_view(page, "Records")
        page.get_by_label("Part, operator").fill("long")
        open_first(page, "long")
        part = page.get_by_role("region", name="Clouds")
        calibration = part.get_by_label("Calibration")
        expect(calibration.locator("option:checked")).to_have_text(re.compile("in use then$"))
        calibration.select_option(clouds.TODAYS)
        part.get_by_role("button", name="Make cloud").click()
        expect(part.get_by_text(f"The cloud with {clouds.TODAYS} is being made")).to_be_visible()
        page.screenshot(path=pictures / "fleet-cloud-being-made.png")
        with page.expect_download() as begun:  # a process begins and makes it
            part.get_by_role("link", name="Download").click()
        assert begun.value.path().read_bytes()[:4] == b"LASF"
        assert begun.value.suggested_filename.endswith(".copc.laz")
        expect(part.get_by_text("It is made already")).to_be_visible()
        page.screenshot(path=pictures / "fleet-cloud-1280.png")
        page.set_viewport_size({"width": 1024, "height": 768})
        page.get_by_role("button", name="Deutsch").click()
        page.get_by_role("button", name="Datensätze").click()
        page.get_by_label("Teil").fill("long")
        open_first(page, "long")
        expect(page.get_by_role("link", name="Herunterladen")).to_be_visible()
        page.screenshot(path=pictures / "fleet-cloud-1024-de.png")
        assert page.evaluate("document.documentElement.scrollWidth") == 1024
        choose_for_each_sensor(page, pictures)
        page.close()


def choose_for_each_sensor(page: Page, pictures: Path) -> None:
    """Of a scan of two, one sensor keeps the calibration of the day."""
    page.get_by_role("button", name="English").click()
    open_view(page, "Records")
    page.get_by_label("Part, operator").fill("two")
    open_first(page, "two")
    part = page.get_by_role("region", name="Clouds")
    part.get_by_label("Calibration, sensor S-1").select_option(clouds.TODAYS)
    other = part.get_by_label("Calibration, sensor S-2")
    expect(other.locator("option:checked")).to_have_text("Of the day of the scan")
    part.get_by_role("button", name="Make cloud").click()
    expect(part.get_by_role("link", name="Download")).to_be_visible()
    expect(part.get_by_role("row").last).to_contain_text(f"{clouds.TODAYS}, {clouds.FOREIGN}")
    for width, language in ((1280, "English"), (820, "English"), (820, "Deutsch")):
        page.set_viewport_size({"width": width, "height": 900})
        if language == "Deutsch":
            page.get_by_role("button", name=language).click()
            page.get_by_role("button", name="Datensätze").click()
            page.get_by_label("Teil").fill("two")
            open_first(page, "two")
            expect(page.get_by_label("Kalibrierung, Sensor S-1")).to_be_visible()
        page.screenshot(path=pictures / f"fleet-sensors-{width}-{language}.png")
        assert page.evaluate("document.documentElement.scrollWidth") == width


def test_wrong_calibrations_are_marked_where_a_cloud_is_made(page: Page, pictures: Path) -> None:
    open_view(page, "Records")
    page.get_by_label("Station").select_option("room-2")
    page.get_by_label("Kind").select_option("scan")
    page.get_by_label("From").fill((WRONG_SINCE + timedelta(days=5)).date().isoformat())
    page.get_by_label("Until").fill((WRONG_SINCE + timedelta(days=8)).date().isoformat())
    open_first(page, f"{WRONG_SINCE + timedelta(days=8):%Y-%m-%d}")
    part = page.get_by_role("region", name="Clouds")
    used = part.get_by_label("Calibration").locator("option:checked")
    expect(used).to_have_text(re.compile("in use then – wrong$"))
    doubt = part.get_by_text(re.compile("Wrong by the drift of the tests: .*Location"))
    expect(doubt).to_be_visible()
    choices = part.get_by_label("Calibration").locator("option")
    expect(choices.filter(has_text="– wrong")).to_have_count(2)
    expect(choices.filter(has_text="– perhaps wrong").first).to_be_attached()
    show_clouds(page, pictures, "en")
    perhaps = choices.filter(has_text="– perhaps wrong").first.get_attribute("value")
    part.get_by_label("Calibration").select_option(perhaps)
    expect(part.get_by_text(re.compile("Perhaps wrong by the drift"))).to_be_visible()
    part.get_by_label("Calibration").select_option(index=0)
    expect(part.get_by_text("by the drift of the tests")).to_have_count(0)
    page.get_by_role("button", name="Deutsch").click()
    page.get_by_role("button", name="Datensätze").click()
    page.get_by_label("Station").select_option("room-2")
    page.get_by_label("Art").select_option("scan")
    page.get_by_label("Von").fill((WRONG_SINCE + timedelta(days=5)).date().isoformat())
    page.get_by_label("Bis").fill((WRONG_SINCE + timedelta(days=8)).date().isoformat())
    open_first(page, f"{WRONG_SINCE + timedelta(days=8):%Y-%m-%d}")
    expect(page.get_by_text("Falsch nach der Drift der Prüfungen")).to_be_visible()
    show_clouds(page, pictures, "de")


def show_clouds(page: Page, pictures: Path, language: str) -> None:
    for width in (1280, 820):
        page.set_viewport_size({"width": width, "height": 900})
        page.screenshot(path=pictures / f"fleet-doubts-{width}-{language}.png")
        assert page.evaluate("document.documentElement.scrollWidth") == width


def test_a_drift_names_its_recordings(page: Page) -> None:
    open_view(page, "Drift")
    expect(page.get_by_role("img")).to_have_count(3)
    changed = page.get_by_text("Changed by")
    expect(changed).to_have_count(1)
    page.locator("summary").click()
    expect(page.locator("details li").first).to_be_visible()
    expect(page.get_by_text("because it is the first level")).to_be_visible()
    page.get_by_label("Level taken as right").select_option(index=2)
    expect(page.get_by_text("Taken as right, as chosen")).to_be_visible()
    expect(page.get_by_text("from the first value on")).to_be_visible()


def test_calibrations_stand_in_frames_in_german(page: Page) -> None:
    page.get_by_role("button", name="Deutsch").click()
    page.get_by_role("button", name="Kalibrierungen").click()
    newest = page.get_by_role("region", name="Neueste Kalibrierungen")
    expect(newest.get_by_role("row")).to_have_count(4)
    title = newest.get_by_role("columnheader", name="Standardunsicherheit eines Punktes")
    expect(title).to_be_visible()
    for width in (1280, 1024):
        page.set_viewport_size({"width": width, "height": 800})
        assert page.evaluate("document.documentElement.scrollWidth") == width
    spread = page.get_by_role("region", name="Streuung aller Kalibrierungen")
    expect(spread.get_by_role("row", name="room-2")).to_be_visible()
    page.locator("select").select_option("laser-plane-offset")
    expect(spread.get_by_role("img")).to_have_count(3)


def test_ageing_is_drawn_against_hours_and_temperature(page: Page) -> None:
    open_view(page, "Ageing")
    expect(page.get_by_role("img")).to_have_count(3)
    expect(page.get_by_text("Hours since the calibration in use").first).to_be_visible()
    page.get_by_role("button", name="Temperature").click()
    expect(page.get_by_text("Above the temperature").first).to_be_visible()
    expect(page.get_by_text("(95 %)")).to_have_count(3)


def test_a_person_signs_in_and_out_again(browser: Browser, tmp_path: Path, pictures: Path) -> None:
    port = free_port()
    with mock_provider() as provider:
        provider.register(f"http://127.0.0.1:{port}/sign-in")
        provider.put("1", preferred_username="Anna", groups=["measuring-room"])
        issuer = provider.issuer.replace("127.0.0.1", "localhost")
        settings = write_settings(tmp_path, provider, issuer)
        with running_fleet(settings, "--port", str(port)):
            page = browser.new_context(viewport={"width": 1024, "height": 768}).new_page()
            page.goto(f"http://127.0.0.1:{port}/?lang=en")
            button = page.get_by_role("button", name="Sign in with Keycloak")
            expect(page.get_by_role("link", name="With the password of this page")).to_be_visible()
            page.screenshot(path=pictures / "fleet-sign-in.png")
            button.click()
            page.locator("input[name=sub]").first.fill("1")
            page.get_by_role("button", name="Authorize").first.click()
            expect(page.get_by_text("Anna")).to_be_visible()
            expect(page.get_by_role("heading", name="room-1")).to_be_visible()
            assert page.url == f"http://127.0.0.1:{port}/"
            page.get_by_role("button", name="Sign out").click()
            page.wait_for_url("**/end_session**")
            page.get_by_role("button").first.click()
            expect(button).to_be_visible()
            page.context.close()
