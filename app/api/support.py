"""The support bundle: what somebody who helps needs to know, and nothing that opens a door."""

import io
import json
import sys
import threading
import traceback
import zipfile
from contextlib import suppress
from dataclasses import asdict
from pathlib import Path

from pydantic_core import to_jsonable_python

from app.errors import Refusal
from app.formats.open_file import read_bounded
from app.monitoring.redaction import Redactor, secrets_in, secrets_of
from app.operations.context import Context
from app.operations.health_checks import Examiner, packages, software
from app.operations.status_report import report_of
from app.timestamps import utc_now

JOURNAL_ROWS = 5000
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
    """The bundle as a zip file. It takes a second."""
    watch, store = context.watch, context.store
    redactor = _redactor(context)
    files: dict[str, str] = {"README.txt": README.format(at=utc_now())}

    def put(name: str, value: object) -> None:
        plain = redactor.value(to_jsonable_python(value, inf_nan_mode="null"))
        files[name] = json.dumps(plain, indent=1, ensure_ascii=False) + "\n"

    put("health.json", asdict(watch.health or Examiner(context).look()))
    put("report.json", report_of(context).model_dump())
    put("software.json", {"software": software(context), "packages": packages()})
    webhook = watch.webhook.settings
    put(
        "settings.json",
        {
            "station": dict(watch.settings.told),
            "scans": context.settings.view(),
            "notifications": {
                "host": webhook.host,
                **{kind: getattr(webhook, kind) for kind in ("done", "fault", "due")},
                "sent": watch.webhook.sent,
                "given_up": watch.webhook.failed,
                "trouble": watch.webhook.trouble,
            },
            "event_loop": asdict(watch.watchdog.stalls),
        },
    )
    files["journal.jsonl"] = _lines(redactor, store.journal.newest(JOURNAL_ROWS))
    audit = [
        {"at": one.at, "act": one.act, "outcome": one.outcome}
        for one in reversed(store.audit.newest(JOURNAL_ROWS))
    ]
    files["audit.jsonl"] = _lines(redactor, audit)
    for path in watch.logs.files():
        files[f"logs/{path.name}"] = _log(redactor, path)
    files["threads.txt"] = redactor.text(_threads())
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return packed.getvalue()


def _redactor(context: Context) -> Redactor:
    watch, store = context.watch, context.store
    webhook = watch.webhook.settings
    secrets = [webhook.secret, *secrets_of(webhook.url), context.entrance.code or ""]
    secrets += secrets_in(dict(watch.settings.told))
    if watch.settings.mqtt is not None:
        with suppress(Refusal):  # what cannot be read cannot have leaked
            secrets.append(watch.settings.mqtt.password() or "")
    people = {account.name for account in store.accounts.all()}
    people |= {entry.who for entry in store.audit.newest(100_000)}
    people |= {wall.made_by for wall in store.sign_ins.walls()}
    return Redactor(secrets, people, {"DATA": store.folder, "HOME": Path.home()})


def _lines(redactor: Redactor, rows: object) -> str:
    plain = to_jsonable_python(rows, inf_nan_mode="null")
    assert isinstance(plain, list)
    return "".join(f"{json.dumps(redactor.value(row), ensure_ascii=False)}\n" for row in plain)


def _log(redactor: Redactor, path: Path) -> str:
    """Line by line, so that what is redacted stays JSON."""
    lines = []
    for text in read_bounded(path).decode("utf-8", "replace").splitlines():
        try:
            value = json.loads(text)
        except ValueError:
            value = {"text": text}
        lines.append(json.dumps(redactor.value(value), ensure_ascii=False))
    return "\n".join(lines) + "\n"


def _threads() -> str:
    names = {thread.ident: thread.name for thread in threading.enumerate()}
    parts = [
        f"{names.get(number, number)}\n{''.join(traceback.format_stack(frame))}"
        for number, frame in sys._current_frames().items()
    ]
    return "\n".join(parts)
