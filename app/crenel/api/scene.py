"""The 3D view: the scans that it shows, their colours, and the elements measured in it."""

from typing import Annotated

from fastapi import Path
from starlette.status import HTTP_204_NO_CONTENT

from crenel.api.access.authorization import StationRouter
from crenel.api.answers.lookups import check_not_recorded, find_scan
from crenel.messages.message import message
from crenel.operations.context import TheContext
from crenel.operations.library.record_view import as_stored_scan
from crenel.station.view3d.selection import Rectangle
from crenel.station.view3d.view_controller import ViewState
from crenel.wire.schema import (
    Colouring,
    CutRegion,
    ElementChange,
    ElementPair,
    OnOff,
    PageView,
    Region,
    ViewRectangle,
)

router = StationRouter(prefix="/api")
ScanId = Annotated[str, Path(max_length=128)]


@router.get("/view")
def view(context: TheContext) -> ViewState:
    """The state of the 3D view."""
    return context.view_controller.state()


@router.post("/view/colours")
def colours(asked: Colouring, context: TheContext) -> ViewState:
    """Colours the clouds by another quantity, or with other limits."""
    limits = None if asked.low is None or asked.high is None else (asked.low, asked.high)
    context.view_controller.colour_by(asked.measure, limits)
    return context.view_controller.state()


@router.post("/view/viewpoint", status_code=HTTP_204_NO_CONTENT)
def turn(asked: PageView, context: TheContext) -> None:
    """Shows the clouds to one page from above, from the front, from the side, or as a whole."""
    context.view_controller.pages.turn(asked.view, asked.viewpoint)


@router.post("/view/fits")
def fit(asked: Region, context: TheContext) -> ViewState:
    """Starts fitting an element to what a page shows in a rectangle."""
    context.view_controller.fit(asked.view, _rectangle(asked), asked.shape)
    return context.view_controller.state()


@router.post("/view/fits/{fit_id}/shape")
def change_element(fit_id: int, asked: ElementChange, context: TheContext) -> ViewState:
    """Starts fitting another shape to the pick of an element."""
    context.view_controller.change_element(fit_id, asked.shape)
    return context.view_controller.state()


@router.delete("/view/fits/last-change")
def undo_element(context: TheContext) -> ViewState:
    """Takes back the last change of elements and of dimensions between them."""
    context.view_controller.undo_element()
    return context.view_controller.state()


@router.delete("/view/fits/{fit_id}")
def remove_fit(fit_id: int, context: TheContext) -> ViewState:
    """Removes an element, or a dimension; does nothing if it has already been removed."""
    context.view_controller.remove_element(fit_id)
    return context.view_controller.state()


@router.post("/view/relations")
def relate(asked: ElementPair, context: TheContext) -> ViewState:
    """Starts measuring between two elements."""
    context.view_controller.relate(asked.first, asked.second)
    return context.view_controller.state()


@router.post("/view/cuts")
def cut(asked: CutRegion, context: TheContext) -> ViewState:
    """Cuts points away in the view and in saved clouds; recordings stay whole."""
    context.view_controller.cut(asked.view, _rectangle(asked), asked.outside)
    return context.view_controller.state()


@router.delete("/view/cuts/last")
def undo_cut(context: TheContext) -> ViewState:
    """Shows again what was cut away last."""
    context.view_controller.undo_cut()
    return context.view_controller.state()


@router.post("/view/arm")
def show_arm(asked: OnOff, context: TheContext) -> ViewState:
    """Shows the arm with its sensor, or hides it."""
    context.view_controller.show_arm(asked.on)
    return context.view_controller.state()


@router.post("/view/weak")
def mark_weak(asked: OnOff, context: TheContext) -> ViewState:
    """Shows weak points in colours of their own, or like the others."""
    context.view_controller.mark_weak(asked.on)
    return context.view_controller.state()


@router.post("/scans/{scan_id}/shown")
def show(scan_id: ScanId, asked: OnOff, context: TheContext) -> ViewState:
    """Shows a scan in the view, or hides it; its files stay."""
    if asked.on:
        context.view_controller.show(as_stored_scan(find_scan(context, scan_id)))
    else:
        check_not_recorded(context, scan_id, message("cannot-hidden-now"))
        context.view_controller.hide(scan_id)
    return context.view_controller.state()


def _rectangle(asked: ViewRectangle) -> Rectangle:
    return Rectangle(asked.left, asked.top, asked.right, asked.bottom)
