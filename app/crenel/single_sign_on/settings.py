"""``[sign_in]`` of station.toml: the provider of the plant's accounts, and their roles."""

import os
from collections.abc import Mapping
from importlib.util import find_spec
from typing import Annotated, Literal, Self, TypeAlias
from urllib.parse import urlsplit

from pydantic import Field, ValidationInfo, model_validator

from crenel.errors import OperationError
from crenel.formats.settings.toml_table import (
    NonEmpty,
    SettingsPath,
    TomlTable,
    check_authority,
    read_secret,
)
from crenel.messages.message import message

RoleName: TypeAlias = Literal["viewer", "operator", "admin"]
SECRET_VARIABLE = "CRENEL_SIGN_IN_SECRET"
"""The environment variable with the client secret, if no file has it."""
LOOPBACK = ("localhost", "127.0.0.1", "::1")
CODE = "settings-sign-in"

Words = Annotated[tuple[NonEmpty, ...], Field(strict=False)]


class SignInSettings(TomlTable):
    """``[sign_in]`` of station.toml."""

    name: Annotated[NonEmpty, Field(max_length=40)]
    """What people call the provider; on the button of the sign-in page."""
    issuer: NonEmpty
    """The provider's address, as in its own configuration."""
    client_id: NonEmpty
    client_secret_file: SettingsPath | None = None
    """Contains only the client secret; else the environment variable ``CRENEL_SIGN_IN_SECRET``."""
    ca_file: SettingsPath | None = None
    """Certificates of the provider's authority; else those of the system."""
    scopes: Words = ("openid", "profile")
    name_claim: NonEmpty = "preferred_username"
    groups_claim: NonEmpty = "groups"
    """The name of a claim, or a path in it such as ``realm_access.roles``."""
    roles: Annotated[dict[NonEmpty, RoleName], Field(min_length=1)]
    """The role of each group."""
    allowed_groups: Words = ()
    """If given, only members of one of these may sign in."""
    sign_out: Literal["provider", "station"] = "provider"
    """Where signing out of the station signs out."""

    @model_validator(mode="after")
    def _check(self, info: ValidationInfo) -> Self:
        _check_issuer(self.issuer, info)
        if "openid" not in self.scopes:
            raise OperationError(
                CODE,
                message("sign-in-scopes-lack-openid", file=str(info.context)),
                message("sign-in-needs-openid"),
                message("sign-in-add-openid"),
            )
        if self.ca_file is not None:
            where, remedy = f"{info.context}, [sign_in]", message("authority-give-for-provider")
            check_authority(self.ca_file, CODE, where, remedy)
        if self.client_secret_file is not None:
            self.client_secret()
        if find_spec("joserfc") is None:
            raise OperationError(
                CODE,
                message("sign-in-unusable", file=str(info.context)),
                message("sign-in-library-missing"),
                message("sign-in-install-library"),
            )
        return self

    def client_secret(self, environment: Mapping[str, str] = os.environ) -> str | None:
        """The client secret, without the line ending; None for a public client.

        Raises:
            OperationError: its file cannot be read.
        """
        if self.client_secret_file is None:
            return environment.get(SECRET_VARIABLE) or None
        remedy = message("sign-in-name-secret-file")
        return read_secret(self.client_secret_file, CODE, remedy).strip() or None


def is_encrypted_or_local(address: str) -> bool:
    """Whether nobody on the network can read what is sent to an address: over TLS, or to this
    machine."""
    try:
        parts = urlsplit(address)
        local = parts.scheme == "http" and parts.hostname in LOOPBACK
        usable = bool(parts.hostname) and parts.port != 0  # raises for a larger one than there is
        return usable and (parts.scheme == "https" or local)
    except ValueError:
        return False


def _check_issuer(issuer: str, info: ValidationInfo) -> None:
    if not is_encrypted_or_local(issuer) or "?" in issuer or "#" in issuer:
        raise OperationError(
            CODE,
            message("sign-in-issuer-is", file=str(info.context), issuer=repr(issuer)),
            message("sign-in-issuer-must-be"),
            message("sign-in-give-issuer"),
        )
