"""Devices of the station: finding, trying and choosing them."""

from typing import Annotated, Literal

from pydantic import Field
from starlette.responses import Response
from starlette.status import HTTP_204_NO_CONTENT

from crenel.api.access.authorization import StationRouter, ThePerson
from crenel.operations.context import TheContext
from crenel.operations.device_setup import DevicesView
from crenel.station.setup.trial_view import TrialView
from crenel.wire.schema import RequestBody

router = StationRouter(prefix="/api/devices")

OptionValue = (
    bool
    | int
    | Annotated[float, Field(allow_inf_nan=False)]
    | Annotated[str, Field(max_length=1000)]
    | Annotated[list[bool | int | float | str], Field(max_length=100)]
)


class ChosenDriver(RequestBody):
    """A driver and its options; numbers may be entered as text."""

    kind: Literal["arm", "sensor"]
    driver: Annotated[str, Field(min_length=1, max_length=100)]
    options: Annotated[
        dict[Annotated[str, Field(max_length=100)], OptionValue], Field(max_length=100)
    ]


class ChosenDevice(ChosenDriver):
    """A device to be saved, with the name that people give it."""

    label: Annotated[str, Field(max_length=60)] = ""


class StripeDirection(RequestBody):
    stripe_axis: Literal["u", "v"]
    """"u" if the laser line runs across the picture, "v" if it runs down."""


class DeviceRemoval(RequestBody):
    kind: Literal["arm", "sensor"]


@router.get("")
def devices(context: TheContext) -> DevicesView:
    """The devices in use, those that were found, and the drivers."""
    return context.device_setup.view()


@router.post("/search")
def search(context: TheContext) -> DevicesView:
    """Searches for devices that are connected; ends within some seconds."""
    context.device_setup.search.start()
    return context.device_setup.view()


@router.post("")
def choose(asked: ChosenDevice, context: TheContext, person: ThePerson) -> DevicesView:
    """Saves a device in station.toml, and uses it at once."""
    context.lease.act(person)
    setup = context.device_setup
    setup.choose(asked.kind, asked.driver, asked.options, asked.label)
    return setup.view()


@router.post("/remove")
def remove(asked: DeviceRemoval, context: TheContext, person: ThePerson) -> DevicesView:
    """Takes a device out of station.toml; a demonstration uses its simulated device again."""
    context.lease.act(person)
    context.device_setup.remove(asked.kind)
    return context.device_setup.view()


@router.post("/datasheet")
def describe(asked: StripeDirection, context: TheContext) -> DevicesView:
    """Writes the datasheet of the chosen camera into the data folder."""
    context.device_setup.describe(asked.stripe_axis)
    context.datasheets.note_change()
    return context.device_setup.view()


@router.post("/arm-datasheet")
def describe_arm(context: TheContext) -> DevicesView:
    """Writes the datasheet of the chosen arm, which reports poses, into the data folder."""
    context.device_setup.describe_arm()
    context.datasheets.note_change()
    return context.device_setup.view()


@router.post("/trial")
def start_trial(asked: ChosenDriver, context: TheContext) -> TrialView:
    """Opens a device for a look; it is closed when nobody looks any more, or after a time."""
    return context.device_setup.try_device(asked.kind, asked.driver, asked.options)


@router.get("/trial")
def trial(context: TheContext) -> TrialView | None:
    """The device that is tried; whoever asks keeps it open."""
    return context.device_setup.trials.view()


@router.get("/trial/picture.jpg")
def picture(context: TheContext) -> Response:
    """Its newest picture; nothing (204) before the first, and when the trial has ended."""
    content = context.device_setup.trials.picture()
    if content is None:
        return Response(status_code=HTTP_204_NO_CONTENT)
    return Response(content, media_type="image/jpeg", headers={"Cache-Control": "no-store"})


@router.delete("/trial", status_code=HTTP_204_NO_CONTENT)
def stop_trial(context: TheContext) -> None:
    """Closes the device that is tried."""
    context.device_setup.trials.stop()
