"""The built files of the client in ``static``; light to import, like ``json_response``."""

import re
from mimetypes import guess_type
from pathlib import Path

from starlette.responses import FileResponse, HTMLResponse, Response

from crenel.formats.open_file import read_bounded

STATIC = Path(__file__).resolve().parents[1] / "static"
OWN_FOLDER = '"./'
"""Before each file that a built page names."""
CODINGS = {"br": ".br", "gzip": ".gz"}
"""Ends of the names of compressed files, by their codings, the smaller first."""
FOREVER = "public, max-age=31536000, immutable"
NOT_BUILT = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Crenel</title>
<style>body{font:16px/1.5 system-ui,sans-serif;max-width:40rem;margin:15vh auto;padding:0 1rem}
</style></head><body><h1>The client is not built</h1>
<p>The station runs, and its interface answers under <code>/api</code>, but the pages of the
operator's client were not built into this copy of the program.</p>
<p>Install the program with <code>pip install .</code>, which builds them, or build them in
the source tree: <code>npm ci &amp;&amp; npm run build</code> in <code>frontend</code>.</p>
</body></html>
"""


def file_response(path: str, accepts: str = "") -> Response | None:
    """A built file by its address; None if there is none.

    Args:
        accepts: the request's ``Accept-Encoding``; the build has compressed what is large.
    """
    try:
        file = (STATIC / path).resolve()
        if not (path and file.is_file() and file.is_relative_to(STATIC)):
            return None
    except (OSError, ValueError):  # no file can have such a name
        return None
    # names under assets carry a hash of their content
    hashed = file.is_relative_to(STATIC / "assets")
    headers = {"Cache-Control": FOREVER if hashed else "no-cache"}
    compressed = {
        coding: name for coding, end in CODINGS.items() if (name := Path(f"{file}{end}")).is_file()
    }
    if not compressed:
        return FileResponse(file, headers=headers)
    # a cache between station and browser keeps each form for those who understand it
    headers["Vary"] = "Accept-Encoding"
    coding = next((one for one in compressed if _is_accepted(one, accepts)), None)
    if coding is None:
        return FileResponse(file, headers=headers)
    headers["Content-Encoding"] = coding
    kind = guess_type(file.name)[0]
    return FileResponse(compressed[coding], media_type=kind, headers=headers)


def _is_accepted(coding: str, accepts: str) -> bool:
    """Whether ``Accept-Encoding`` names a coding, with any weight but zero."""
    for one in accepts.lower().split(","):
        name, *parameters = (part.strip() for part in one.split(";"))
        if name == coding:
            return not any(re.fullmatch(r"q\s*=\s*0(\.0*)?", part) for part in parameters)
    return False


def page_response(name: str, base: str) -> Response:
    """One of the built pages, whatever the address: it selects its own view.

    Args:
        base: before the addresses of the page's files, as ``page_base`` has it.
    """
    page = STATIC / name
    if not page.is_file():
        return HTMLResponse(NOT_BUILT, 503)
    text = read_bounded(page).decode().replace(OWN_FOLDER, f'"{base}')
    return HTMLResponse(text, headers={"Cache-Control": "no-cache"})


def names_a_file(path: str) -> bool:
    """Whether an address asks for a file, not for a page."""
    return path.startswith("assets/") or "." in path.rsplit("/", 1)[-1]
