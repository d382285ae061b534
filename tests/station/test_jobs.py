"""Long work off the event loop."""

import asyncio
import threading
from collections.abc import Callable

import pytest

from app.errors import OperationError
from app.station.bus import Bus
from app.station.jobs import Job, Jobs, Progress


def run(bus: Bus, jobs: Jobs, work: Callable[[Progress], int]) -> Job[int]:
    async def scenario() -> Job[int]:
        loop = asyncio.get_running_loop()
        bus.attach(loop)
        ended: asyncio.Future[Job[int]] = loop.create_future()
        jobs.start("Solving", work, ended.set_result)
        return await asyncio.wait_for(ended, 240)

    return asyncio.run(scenario())


def test_work_runs_on_a_thread_and_reports_its_progress(bus: Bus) -> None:
    jobs, seen = Jobs(bus), []

    def work(progress: Progress) -> int:
        progress("half of it", 0.5)
        assert jobs.current is not None
        seen.append((threading.current_thread().name, jobs.current.text, jobs.current.fraction))
        return 42

    job = run(bus, jobs, work)
    assert (job.result, job.refusal, job.finished) == (42, None, True)
    assert seen == [("job-Solving", "half of it", 0.5)]
    assert jobs.current is None


def test_a_refusal_and_a_mistake_both_end_as_a_reason(bus: Bus) -> None:
    def refuse(progress: Progress) -> int:
        raise OperationError("too-few-contacts", "four contacts", "six are needed")

    def fail(progress: Progress) -> int:
        return 1 // 0

    jobs = Jobs(bus)
    refused = run(bus, jobs, refuse).refusal
    assert refused is not None
    assert refused.code == "too-few-contacts"
    failed = run(bus, jobs, fail).refusal
    assert failed is not None
    assert "division" in str(failed.why)
    assert jobs.current is None


def test_one_job_at_a_time(bus: Bus) -> None:
    jobs, go_on = Jobs(bus), threading.Event()
    jobs.start("Solving", lambda progress: go_on.wait(240), lambda job: None)
    with pytest.raises(OperationError, match="Solving is still running"):
        jobs.start("Another", lambda progress: 1, lambda job: None)
    go_on.set()
    jobs.wait(240)
    jobs.start("Another", lambda progress: 1, lambda job: None)
    jobs.wait(240)
