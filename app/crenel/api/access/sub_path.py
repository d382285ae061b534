"""The sub-path under which a proxy offers the server: ``/crenel`` of ``https://plant/crenel/``.

Routes and permissions know no sub-path: ``crenel.server.behind_proxy`` removes it from the path of
a request, and notes it beside. Light to import, like ``static_files``.
"""

from collections.abc import MutableMapping
from typing import Any

SUB_PATH = "crenel.sub_path"
"""Its key in the scope of a request."""


def sub_path_of(scope: MutableMapping[str, Any]) -> str:
    """The sub-path of a request, with a slash before it and none behind; empty if there is none,
    or if neither a proxy nor the settings state it."""
    found: str = scope.get(SUB_PATH, "")
    return found


def without_sub_path(scope: MutableMapping[str, Any], sub_path: str) -> dict[str, Any]:
    """The scope of a request with its sub-path noted.

    Args:
        sub_path: as ``sub_path_of`` has it; removed from the path if the proxy passed it on.
    """
    path, raw = scope["path"], scope.get("raw_path") or b""
    if path == sub_path or path.startswith(f"{sub_path}/"):
        path = path.removeprefix(sub_path) or "/"
        raw = raw.removeprefix(sub_path.encode()) or b"/"
    return {**scope, "path": path, "raw_path": raw, SUB_PATH: sub_path}


def page_base(scope: MutableMapping[str, Any]) -> str:
    """What a page puts before the addresses of its files, with a slash at its end.

    Without a known sub-path it is relative to the address of the page: then the page also works
    behind a proxy that removes a sub-path and says nothing about it, and can say what is missing.
    """
    if known := sub_path_of(scope):
        return f"{known}/"
    path: bytes = scope.get("raw_path") or scope["path"].encode()
    return "../" * (path.partition(b"?")[0].count(b"/") - 1) or "./"
