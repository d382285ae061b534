"""The support bundle: information for support, and nothing that gives access."""

import io
import json
import logging
import sys
import threading
import traceback
import zipfile
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, fields, is_dataclass
from functools import partial
from pathlib import Path

from pydantic import BaseModel
from pydantic_core import to_jsonable_python

from crenel.errors import OperationError
from crenel.formats.open_file import read_tail
from crenel.messages.stored import RENDERED
from crenel.monitoring.health import Health
from crenel.monitoring.redaction import Redactor, address_secrets, secrets_in
from crenel.operations.context import Context
from crenel.operations.health_checks import HealthChecker, packages, software
from crenel.operations.status_report import build_report
from crenel.timestamps import utc_now

log = logging.getLogger(__name__)
JOURNAL_ROWS = 5000
LOG_BYTES = 4_000_000
"""For each file of the log; the log rotates at half of that."""
LONGEST_ERROR = 4000
README = """A Crenel station's support bundle, made {at}.

health.json     every check, with what, why and what to do
report.json     what the station was doing
software.json   versions and packages
settings.json   station.toml as it is in use, and the settings of scans
journal.jsonl   the last steps of the guided flows
audit.jsonl     what was done, by whom left out
logs/           the program's log, JSON lines
threads.txt     what every thread was doing

Passwords, tokens, keys, addresses and people's names were taken out. Look it over before you
send it; nothing was sent anywhere.
"""


def bundle(context: Context) -> bytes:
    """The bundle as a zip file. It takes a second.

    A part that cannot be made contains its error; the others are made.
    """
    redactor = context_redactor(context)
    parts: dict[str, Callable[[], str]] = {
        "README.txt": lambda: README.format(at=utc_now()),
        "health.json": lambda: _document(redactor, _health(context)),
        "report.json": lambda: _document(redactor, build_report(context).model_dump()),
        "software.json": lambda: _document(
            redactor, {"software": software(context), "packages": packages()}
        ),
        "settings.json": lambda: _document(redactor, _settings(context)),
        "journal.jsonl": lambda: _lines(redactor, context.store.journal.newest(JOURNAL_ROWS)),
        "audit.jsonl": lambda: _lines(redactor, _audit(context)),
        "threads.txt": lambda: redactor.text(_threads()),
    }
    for path in context.monitoring.logs.files():
        parts[f"logs/{path.name}"] = partial(_log, redactor, path)
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, make in parts.items():
            # invalid characters are escaped as in JSON
            archive.writestr(name, _build_part(redactor, make).encode("utf-8", "backslashreplace"))
    return packed.getvalue()


def _build_part(redactor: Redactor, make: Callable[[], str]) -> str:
    try:
        return make()
    except Exception as error:
        log.warning("a part of the support bundle could not be created", exc_info=error)
        text = "".join(traceback.format_exception(error))
        return redactor.text(f"This part could not be created.\n{text[-LONGEST_ERROR:]}")


def _health(context: Context) -> Health:
    return context.monitoring.health or HealthChecker(context).look()


def _settings(context: Context) -> dict[str, object]:
    watch = context.monitoring
    webhook = watch.webhook.settings
    return {
        "station": dict(watch.effective_settings),
        "scans": context.settings.view(),
        "notifications": {
            "host": webhook.host,
            **{kind: getattr(webhook, kind) for kind in ("done", "fault", "due")},
            "sent": watch.webhook.sent,
            "given_up": watch.webhook.failed,
            "trouble": watch.webhook.trouble,
        },
        "event_loop": asdict(watch.watchdog.stalls),
    }


def _audit(context: Context) -> list[dict[str, str]]:
    newest = context.store.audit.newest(JOURNAL_ROWS)
    return [
        {"at": one.at, "act": str(one.act), "outcome": str(one.outcome)} for one in reversed(newest)
    ]


def context_redactor(context: Context) -> Redactor:
    """Takes the station's secrets, its people's names and its folders out of a text."""
    watch, store = context.monitoring, context.store
    webhook = watch.webhook.settings
    secrets = [webhook.secret, *address_secrets(webhook.url), context.authenticator.code or ""]
    secrets += secrets_in(dict(watch.settings_with_secrets))
    if watch.settings.mqtt is not None:
        with suppress(OperationError):  # what cannot be read cannot leak
            secrets.append(watch.settings.mqtt.password() or "")
    if context.provider is not None:
        with suppress(OperationError):
            secrets.append(context.provider.settings.client_secret() or "")
    people = {account.name for account in store.accounts.all()}
    people |= {entry.who for entry in store.audit.newest(100_000)}
    people |= {link.made_by for link in (*store.kiosk_links.all(), *store.api_tokens.all())}
    return Redactor(secrets, people, {"DATA": store.folder, "HOME": Path.home()})


def _document(redactor: Redactor, value: object) -> str:
    plain = redactor.value(to_jsonable_python(_in_english(value), inf_nan_mode="null"))
    return json.dumps(plain, indent=1, ensure_ascii=False) + "\n"


def _in_english(value: object) -> object:
    """A value with English texts, for the reader of the bundle."""
    if isinstance(value, RENDERED):
        return str(value)
    if is_dataclass(value) and not isinstance(value, type):
        return {one.name: _in_english(getattr(value, one.name)) for one in fields(value)}
    if isinstance(value, BaseModel):
        return {name: _in_english(of) for name, of in value}
    if isinstance(value, Mapping):
        return {name: _in_english(of) for name, of in value.items()}
    if isinstance(value, (list, tuple)):
        return [_in_english(one) for one in value]
    return value


def _lines(redactor: Redactor, rows: Sequence[object]) -> str:
    return "".join(f"{_line(redactor, row)}\n" for row in rows)


def _line(redactor: Redactor, row: object) -> str:
    try:
        plain = to_jsonable_python(row, inf_nan_mode="null")
        return json.dumps(redactor.value(plain), ensure_ascii=False)
    except (ValueError, RecursionError) as error:
        return json.dumps({"error": redactor.text(f"{type(error).__name__}: {error}")})


def _log(redactor: Redactor, path: Path) -> str:
    """The end of a file, line by line, so that redacted lines stay JSON."""
    raw, whole = read_tail(path, LOG_BYTES)
    texts = raw.decode("utf-8", "replace").replace("\0", "").splitlines()
    lines = [] if whole else [json.dumps({"text": f"Only the last {LOG_BYTES} bytes are here."})]
    for text in texts if whole else texts[1:]:  # the first line may be cut off
        try:
            value = json.loads(text)
        except (ValueError, RecursionError):
            value = {"text": text}
        lines.append(_line(redactor, value))
    return "\n".join(lines) + "\n"


def _threads() -> str:
    names = {thread.ident: thread.name for thread in threading.enumerate()}
    parts = [
        f"{names.get(number, number)}\n{''.join(traceback.format_stack(frame))}"
        for number, frame in sys._current_frames().items()
    ]
    return "\n".join(parts)
