"""All routers of the application, in the order in which paths are matched."""

from app.api import (
    calibrations,
    health,
    live,
    metrics,
    notifications,
    records,
    reports,
    scan,
    scene,
    settings,
)
from app.api.access import accounts, auth, tokens
from app.api.files import client
from app.api.sessions import arm, calibration, verification
from app.api.viewer import proxy

ROUTERS = (
    auth.router,
    accounts.router,
    tokens.router,
    calibration.router,
    arm.router,
    verification.router,
    calibrations.router,
    scan.router,
    settings.router,
    records.router,
    reports.router,
    health.router,
    notifications.router,
    metrics.router,
    scene.router,
    live.router,
    proxy.router,
    client.router,
)
"""The client's router is the last one, because it answers every other path."""
