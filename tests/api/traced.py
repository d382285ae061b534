"""The log of a station's calls to the disk and the network, and what of it was kept when."""

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple


class Call(NamedTuple):
    name: str
    file: int
    text: str
    """A path, or the first bytes that were sent or received."""


class Trace:
    """The calls of one process, in their order; times are indices into them."""

    def __init__(self, log: Path, data: Path) -> None:
        self._data = str(data)
        self.calls = []
        for line in log.read_text(errors="replace").split("\n")[:-1]:
            name, file, text = line.split("\t", 2)
            self.calls.append(Call(name, int(file), text))

    def request_index(self, mark: str) -> int:
        at = self._next(0, len(self.calls), "recv", lambda call: f"mark={mark} " in call.text)
        assert at is not None, mark
        return at

    def answer_index(self, mark: str) -> int:
        """When the answer to that request was about to be sent."""
        asked = self.request_index(mark)
        file = self.calls[asked].file
        at = self._next(asked, len(self.calls), "send", lambda call: call.file == file)
        assert at is not None
        assert self.calls[at].text.startswith("HTTP/1.1 2"), self.calls[at]
        return at

    def why_not_stored(self, path: Path, by: int, since: int = 0) -> str:
        """Why a file was not on the disk at a time; empty where it was.

        Its content, its name, and the names of all folders above it that were made.

        Args:
            since: it must have been written after this.
        """
        return self._why_not_synced(str(path), since, by) or self._folders(path, by)

    def _why_not_synced(self, name: str, since: int, by: int) -> str:
        """Whether a file's content and its name were."""
        wrong = ""
        renames = self._all(since, by, ("rename",), name)
        if not renames:
            wrong = self._content(name, since, by)
            made = self._next(0, by, "make", lambda call: call.text == name)
            if not wrong and made is not None:
                wrong = self._why_not_named(name, made, by)
        for renamed in renames:  # the last may be on its way to the disk for what comes next
            wrong = self._content(self.calls[renamed - 1].text, 0, renamed)
            wrong = wrong or self._why_not_named(name, renamed, by)
            if not wrong:
                break
        return wrong

    def why_not_moved(self, folder: Path, by: int) -> str:
        """Why a folder that got its name once it was whole was not kept; empty where it was."""
        renamed = self._next(0, by, "rename", lambda call: call.text == str(folder))
        if renamed is None:
            return f"{folder} was not there"
        part = Path(self.calls[renamed - 1].text)
        for path in sorted(folder.rglob("*")):
            name = str(part / path.relative_to(folder))
            named = (k for k, call in enumerate(self.calls) if call.text == name)
            made = next(k for k in named if self.calls[k].name != "from")
            wrong = self._why_not_named(name, made, renamed)
            if path.is_file():
                wrong = self._why_not_synced(name, 0, renamed)
            if wrong:
                return wrong
        return self._why_not_named(str(folder), renamed, by)

    def why_no_row(self, since: int, by: int) -> str:
        """Why no row of the database was kept in between; empty where one was."""
        return self._content(f"{self._data}/station.db-wal", since, by, any_write=True)

    def _content(self, name: str, since: int, by: int, any_write: bool = False) -> str:
        """Whether the last of what was written, or anything, was synced."""
        writes = self._all(since, by, ("write", "make"), name)
        if not writes:
            return f"{name} was not written"
        begin = writes[0] if any_write else writes[-1]
        synced = self._next(begin, by, "sync", lambda call: call.text == name)
        return "" if synced is not None else f"{name} was not synced"

    def _why_not_named(self, name: str, since: int, by: int) -> str:
        """Whether the folder of a new name was synced."""
        folder = str(Path(name).parent)
        synced = self._next(since, by, "sync", lambda call: call.text == folder)
        return "" if synced is not None else f"{folder} was not synced after {name} was made"

    def _folders(self, path: Path, by: int) -> str:
        for folder in map(str, path.parents):
            if len(folder) <= len(self._data):
                break
            for k in self._all(0, by, ("make", "rename"), folder):
                if wrong := self._why_not_named(folder, k, by):
                    return wrong
        return ""

    def _all(self, since: int, by: int, names: tuple[str, ...], text: str) -> list[int]:
        calls = enumerate(self.calls[since:by], since)
        return [k for k, call in calls if call.name in names and call.text == text]

    def _next(self, since: int, by: int, name: str, fits: Callable[[Call], bool]) -> int | None:
        calls = enumerate(self.calls[since:by], since)
        return next((k for k, call in calls if call.name == name and fits(call)), None)
