"""Admits people whom a provider signed in: at a station, and at the server of the fleet."""

from collections.abc import Callable

from crenel.messages.message import message
from crenel.single_sign_on.errors import SignInError
from crenel.single_sign_on.person import ProviderPerson
from crenel.single_sign_on.settings import SignInSettings
from crenel.store.accounts import Account, AccountStore, Role
from crenel.store.login_sessions import LoginSessionStore


def admit_person(
    person: ProviderPerson,
    provider: SignInSettings,
    accounts: AccountStore,
    sessions: LoginSessionStore,
    end_control: Callable[[str], object],
) -> Account:
    """The account of a person, with the role of today's groups.

    Who has another role than before, or none, is signed out elsewhere.

    Args:
        end_control: ends the control of an account by its name.

    Raises:
        OperationError: they are in no group with a role, or their name is not available.
    """
    before = accounts.find_subject(provider.issuer, person.subject)
    role = None if person.role is None else Role[person.role]
    if before is not None and before.role is not role:
        sessions.end_all(before.name)
        end_control(before.name)
    if role is None:
        raise SignInError(
            "no-group",
            message("sign-in-no-group", person=person.name[:80], name=provider.name),
            message("sign-in-ask-for-group"),
        )
    account = accounts.admit(provider.issuer, person.subject, person.name, role)
    if before is not None and before.name != account.name:
        end_control(before.name)
    return account
