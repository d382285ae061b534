"""Keeps the topics fresh that follow from others: the flow's live part, and home."""

import asyncio
import logging

from app.errors import OperationError
from app.guide.verify.commands import measure_waiting
from app.operations.context import Context
from app.operations.home import build_home

log = logging.getLogger(__name__)
PERIOD_S = 0.2
HOME_EVERY = 5


async def tick(context: Context) -> None:
    """Runs until cancelled; only what changed is published."""
    home = None
    count = 0
    while True:
        try:
            await asyncio.to_thread(context.guide.refresh)
            await asyncio.to_thread(context.arm_guide.refresh)
            await asyncio.to_thread(measure_waiting, context.verify_guide)
            await asyncio.to_thread(context.verify_guide.refresh)
            if count % HOME_EVERY == 0:
                await asyncio.to_thread(context.recovery.step)
            if count % HOME_EVERY == 0:
                found = await asyncio.to_thread(build_home, context)
                if found != home:
                    home = found
                    context.bus.publish("home", home)
        except OperationError as refusal:  # of a damaged database or its disk; Health shows it
            log.warning("the live state could not be refreshed: %s", refusal.line)
        except Exception:  # the station lives on, and the next tick may succeed
            log.exception("the live state could not be refreshed")
        count += 1
        await asyncio.sleep(PERIOD_S)
