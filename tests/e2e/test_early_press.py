"""What is pressed before the link has signed the guest in, on a slow line."""

import pytest
from playwright.sync_api import Browser, expect

from tests.e2e.conftest import Demo
from tests.e2e.visit import Visit

pytestmark = pytest.mark.device

SLOW_SIGN_IN = """
    const send = window.fetch;
    window.fetch = async (path, init) => {
        if (String(path).endsWith("/session/code")) await new Promise((go) => setTimeout(go, 3000));
        return send(path, init);
    };
"""


def test_it_waits_for_the_sign_in(browser: Browser, demo: Demo) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    visit = Visit(page)
    page.add_init_script(SLOW_SIGN_IN)
    page.goto(demo.link)
    page.get_by_role("link", name="Performance").click()
    page.get_by_role("button", name="Contact tests", exact=True).click()
    page.get_by_role("button", name="Start the test").click()
    expect(page.get_by_role("radio", name="Without a sphere")).to_be_visible()
    assert not visit.faults, "\n".join(visit.faults)
    page.close()
