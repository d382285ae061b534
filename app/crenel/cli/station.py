"""``crenel backup``, ``password`` and ``mqtt-schema``: what a station's keeper needs."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from crenel.cli.choice import count_words
from crenel.console import AsJson, print_json, progress_bar, report_errors
from crenel.messages.message import message


@report_errors
def backup(
    data: Annotated[Path, typer.Argument(help="The station's data folder; it may be running.")],
    output: Annotated[Path, typer.Option("-o", "--output", help="The new folder of the copy.")],
    as_json: AsJson = False,
) -> None:
    """Copy a station's data folder, even while the station runs. To use it, start with --data."""
    from dataclasses import asdict

    from crenel.store.backup import backup as copy_all

    with progress_bar("Copying", not as_json) as progress:
        made = copy_all(data, output, progress)
    if as_json:
        print_json(asdict(made))
        return
    print(f"{made.folder} written: {count_words(made.files, 'file')}, {made.bytes / 1e6:.1f} MB")


@report_errors
def password(
    data: Annotated[Path, typer.Argument(help="The station's data folder; it may be running.")],
    name: Annotated[str, typer.Argument(help="Name of the account.")],
) -> None:
    """Set a new password for an account; it is prompted for, or read from stdin."""
    from crenel.errors import OperationError
    from crenel.store.accounts import AccountStore
    from crenel.store.audit import AuditLog
    from crenel.store.backup import DATABASE, check_data_folder
    from crenel.store.database import Database
    from crenel.store.login_sessions import LoginSessionStore

    check_data_folder(data)
    database = Database(data / DATABASE)
    try:
        accounts = AccountStore(database)
        account = accounts.get(name)
        if account is None:
            names = ", ".join(one.name for one in accounts.all())
            known = message("accounts-are", names=names) if names else message("accounts-none")
            raise OperationError("no-account", message("account-not-there", name=name), known)
        if sys.stdin.isatty():
            new = typer.prompt("New password", hide_input=True, confirmation_prompt=True)
        else:
            new = sys.stdin.readline().rstrip("\r\n")
        accounts.set_password(account.name, new)
        LoginSessionStore(database).end_all(account.name)
        AuditLog(database).note("", "console", f"changed an account: {account.name}, new password")
    finally:
        database.close()
    print(f"{account.name} has a new password and is signed out everywhere.")


@report_errors
def mqtt_schema() -> None:
    """Print the JSON schema of the messages that stations publish over MQTT."""
    from crenel.supervision.messages import schema

    print_json(schema())
