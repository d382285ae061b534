"""Starts the fleet's server."""

from pathlib import Path

from crenel.errors import OperationError
from crenel.fleet.catalogue.libraries import check_libraries
from crenel.formats.file_modes import private_files
from crenel.messages.message import message
from crenel.server.listener import (
    LOOPBACK,
    listen,
    local_address,
    log_to_console,
    make_server,
    network_words,
    raise_file_limit,
    with_root_path,
)

PORTS_TRIED = 10


@private_files()
def serve_fleet(
    config: Path | None, host: str, port: int, open_browser: bool, root_path: str = ""
) -> None:
    """Serves until SIGINT or SIGTERM; its files, such as those of accounts, are for its user alone.

    Args:
        root_path: the sub-path under which a proxy offers the page; empty: by the settings.

    Raises:
        OperationError: a library is missing, the settings are wrong, the port is in use, or other
            machines could read the catalogue without a sign-in or a password.
    """
    check_libraries()
    from crenel.fleet.fleet_settings import (
        ACCOUNTS_FILE,
        CLOUDS_FOLDER,
        DEFAULT_FILE,
        read_fleet_settings,
    )
    from crenel.server.fleet.access import open_access
    from crenel.server.fleet.application import build_fleet_app
    from crenel.server.fleet.clouds.service import FleetClouds
    from crenel.server.fleet.service import FleetService

    settings = read_fleet_settings(config)
    serving, password = with_root_path(settings.server, root_path), settings.server.password()
    if host not in LOOPBACK and not password and settings.sign_in is None:
        raise OperationError(
            "fleet-open",
            message("fleet-open-to-all", host=host),
            remedy=message("fleet-set-password"),
        )
    file = config or Path(DEFAULT_FILE)
    beside = file.absolute().parent
    clouds = FleetClouds(settings, settings.clouds.folder or beside / CLOUDS_FOLDER)
    access = open_access(settings.sign_in, serving.accounts or beside / ACCOUNTS_FILE, password)
    app = build_fleet_app(FleetService(settings), clouds, access, serving.hosts)
    server = make_server(app, serving)
    raise_file_limit()
    listening = listen(host, port, PORTS_TRIED)
    server.first_words += network_words(host, serving, file.name)
    log_to_console()
    server.address = local_address(host, listening, serving)
    server.open_browser = open_browser
    try:
        server.run(sockets=[listening])
    except KeyboardInterrupt:
        pass  # uvicorn raises the signal again after a regular end
    finally:
        listening.close()
