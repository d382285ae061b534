"""What the commands of every guided session share: jobs, and the simulated operator."""

from collections.abc import Callable
from typing import Any

from app.errors import OperationError
from app.guide.common.guided_session import GuidedSession
from app.messages.message import Text, message
from app.station.jobs import Job, Progress

AT_ANY_REV = ("stop_simulation",)
"""Stopping must not wait for a fresh view."""


def start_job(
    guide: GuidedSession[Any, Any, Any], title: Text, work: Callable[[Progress], None]
) -> None:
    """Starts a session's work in the background; why it failed is shown in the session."""

    def done(job: Job[None]) -> None:
        if job.refusal is not None:
            guide.decline(job.refusal)
        guide.refresh()

    guide.station.jobs.start(title, work, done)


def start_simulation(guide: GuidedSession[Any, Any, Any], work: Callable[[Progress], None]) -> None:
    """Starts the simulated operator; raises ``OperationError`` while another job runs."""
    guide.simulation_running = True
    try:
        start_job(guide, message("simulation-work"), work)
    except OperationError:
        guide.simulation_running = False
        raise


def stop_simulation(guide: GuidedSession[Any, Any, Any]) -> None:
    """Ends the simulated operator's work in this session early; idempotent."""
    if guide.simulation_running and guide.station.simulated_operator is not None:
        guide.simulation_running = False
        guide.station.simulated_operator.cancel()
