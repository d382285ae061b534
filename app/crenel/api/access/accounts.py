"""Routes for administrators: accounts, and the audit log."""

from typing import Annotated

from fastapi import Query, Request
from starlette.status import HTTP_204_NO_CONTENT

from crenel.api.access.authorization import StationRouter
from crenel.api.access.browser import ROLE_NAMES
from crenel.api.answers.problems import NotFoundError
from crenel.messages.catalogue import translator
from crenel.messages.language_file import ENGLISH
from crenel.messages.message import Text, join, message
from crenel.operations.context import Context, TheContext
from crenel.store.accounts import Account, Role
from crenel.store.audit import AuditEntry
from crenel.wire.sign_in import AccountChange, AccountSummary, NewAccount

router = StationRouter(prefix="/api")
AUDIT_LIMIT = 500
Name = Annotated[str, Query(max_length=200)]
"""Name of an account; not part of a path, because browsers treat some names there as folders."""


@router.get("/accounts")
def accounts(context: TheContext) -> list[AccountSummary]:
    """Lists all accounts by name."""
    return [_summary(account) for account in context.store.accounts.all()]


@router.post("/accounts")
def add(asked: NewAccount, request: Request, context: TheContext) -> AccountSummary:
    """Creates an account."""
    request.state.detail = f"{asked.name}, {asked.role}"
    return _summary(context.store.accounts.add(asked.name, Role[asked.role], asked.password))


@router.post("/account")
def change(
    name: Name, asked: AccountChange, request: Request, context: TheContext
) -> AccountSummary:
    """Sets another role, or a new password; the user is signed out everywhere."""
    account = _account(context, name)
    changed: list[Text] = [account.name]
    if asked.role is not None:
        changed.append(asked.role)
    if asked.password is not None:
        changed.append(message("new-password"))
    request.state.detail = join(changed)
    if asked.role is not None:
        context.store.accounts.set_role(account.name, Role[asked.role])
    if asked.password is not None:
        context.store.accounts.set_password(account.name, asked.password)
    _sign_out(context, account)
    return _summary(_account(context, account.name))


@router.delete("/account", status_code=HTTP_204_NO_CONTENT)
def remove(name: Name, request: Request, context: TheContext) -> None:
    """Removes an account; the user is signed out everywhere."""
    request.state.detail = name
    account = _account(context, name)
    context.store.accounts.remove(account.name)
    _sign_out(context, account)


@router.get("/audit")
def audit(
    context: TheContext,
    words: Annotated[str, Query(max_length=100)] = "",
    lang: Annotated[str, Query(pattern="^[a-z]{2}$")] = ENGLISH,
) -> list[AuditEntry]:
    """The latest entries of the audit log that contain all the words, newest first.

    Words are searched in English and in the user's language.
    """
    return context.store.audit.newest(AUDIT_LIMIT, words, translator(lang) or str)


def _account(context: Context, name: str) -> Account:
    account = context.store.accounts.get(name)
    if account is None:
        raise NotFoundError(message("there-no-account", name=name))
    return account


def _sign_out(context: Context, account: Account) -> None:
    """Signs the user out everywhere; control is released."""
    context.store.login_sessions.end_all(account.name)
    context.lease.leave_all(account.name)


def _summary(account: Account) -> AccountSummary:
    role, by_provider = ROLE_NAMES[account.role], bool(account.provider)
    return AccountSummary(account.name, role, account.made_at, by_provider)
