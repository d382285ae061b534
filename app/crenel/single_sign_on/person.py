"""Who signed in, by the claims of the provider, and with which role."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from crenel.messages.message import message
from crenel.single_sign_on.errors import SignInError
from crenel.single_sign_on.settings import RoleName, SignInSettings

RANKS: tuple[RoleName, ...] = ("viewer", "operator", "admin")


@dataclass(frozen=True, slots=True)
class ProviderPerson:
    """A person with an account of the provider."""

    subject: str
    """Identifies the person at the provider, also after a change of the name."""
    name: str
    role: RoleName | None
    """None: in no group that may sign in."""


def read_person(claims: Mapping[str, Any], settings: SignInSettings) -> ProviderPerson:
    """The person of checked claims.

    Raises:
        SignInError: the claims have no name.
    """
    name = find_claim(claims, settings.name_claim)
    if not isinstance(name, str) or not name.strip():
        raise SignInError(
            "no-name",
            message("sign-in-no-name", name=settings.name, claim=settings.name_claim),
            message("sign-in-map-claim"),
        )
    groups = _groups(find_claim(claims, settings.groups_claim))
    return ProviderPerson(claims["sub"], name, role_of(groups, settings))


def role_of(groups: frozenset[str], settings: SignInSettings) -> RoleName | None:
    """The highest role of these groups; None if their members may not sign in."""
    if settings.allowed_groups and not groups & set(settings.allowed_groups):
        return None
    roles = [settings.roles[group] for group in groups if group in settings.roles]
    return max(roles, key=RANKS.index, default=None)


def find_claim(claims: Mapping[str, Any], name: str) -> object:
    """A claim by its name, or by its path with dots; None if there is none."""
    if name in claims:
        return claims[name]
    found: object = claims
    for part in name.split("."):
        if not isinstance(found, Mapping) or part not in found:
            return None
        found = found[part]
    return found


def _groups(claim: object) -> frozenset[str]:
    several = claim if isinstance(claim, list) else [claim]
    return frozenset(one for one in several if isinstance(one, str))
