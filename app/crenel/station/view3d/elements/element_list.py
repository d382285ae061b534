"""The elements of the 3D view and the dimensions between them: made, changed, removed, undone."""

import logging
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

from crenel.errors import OperationError
from crenel.messages.message import Text, message
from crenel.station.bus import Bus
from crenel.station.view3d.cloud_colouring import ReferenceShape
from crenel.station.view3d.elements.element_views import (
    AskedElement,
    ElementRelation,
    ElementsView,
    FittedShape,
)
from crenel.station.view3d.elements.picked_scans import PickedScan
from crenel.station.view3d.meshes import Mesh
from crenel.station.view3d.scene import Scene
from crenel.station.view3d.selection import Rectangle, ViewCamera

if TYPE_CHECKING:  # imported when the first element is picked
    from crenel.parts.elements.evaluate_element import MeasuredElement

log = logging.getLogger(__name__)

Work = AskedElement | Literal["relation"]
"""What is being fitted."""
MOST_UNDONE = 30


@dataclass(frozen=True, eq=False)
class _Element:
    """An element with its pick and its drawing."""

    view: FittedShape
    measured: "MeasuredElement"
    mesh: Mesh
    camera: ViewCamera
    rectangle: Rectangle


@dataclass(frozen=True)
class _Content:
    """All elements and dimensions, by their numbers."""

    elements: dict[int, _Element] = field(default_factory=dict)
    relations: dict[int, ElementRelation] = field(default_factory=dict)

    def without(self, number: int) -> "_Content":
        """What is left without an element, or without a dimension."""
        return _Content(
            {key: one for key, one in self.elements.items() if key != number},
            {
                key: one
                for key, one in self.relations.items()
                if number not in (key, one.first, one.second)
            },
        )


class ElementList:
    """Fits in a thread of its own; methods may be called from any thread that holds the lock.

    Args:
        lock: held around every change.
        scans: the scans in the view.
        changed: called after every change, with the lock held.
    """

    def __init__(
        self,
        bus: Bus,
        scene: Scene,
        lock: threading.RLock,
        scans: Callable[[], list[PickedScan]],
        changed: Callable[[], None],
    ) -> None:
        self._bus, self._scene, self._lock = bus, scene, lock
        self._scans, self._changed = scans, changed
        self._content = _Content()
        self._before: list[_Content] = []
        self._made = 0
        self._begun = scene.begun
        self._fitter = ThreadPoolExecutor(1, "view-fit")
        self.busy: Text = ""
        """What is being fitted; empty if nothing is."""

    def close(self) -> None:
        """Ends all running work."""
        self._fitter.shutdown(cancel_futures=True)

    @property
    def view(self) -> ElementsView:
        """All of them as the operator reads them."""
        content = self._content
        return ElementsView(
            tuple(one.view for one in content.elements.values()),
            tuple(content.relations.values()),
            bool(self._before),
        )

    @property
    def reference(self) -> ReferenceShape | None:
        """The last element, from which deviations are shown; None without one."""
        if not self._content.elements:
            return None
        last = self._content.elements[max(self._content.elements)]
        return ReferenceShape(last.measured.as_shown.distances, last.view.rms_um / 1e3)

    def forget(self) -> None:
        """A new scan has begun: the scene has already removed everything."""
        self._begun = self._scene.begun
        self._content, self._before = _Content(), []

    def fit(self, camera: ViewCamera, rectangle: Rectangle, asked: AskedElement) -> None:
        """Starts to fit an element to what a browser shows in a rectangle.

        Raises:
            OperationError: another one is being fitted.
        """
        self._made += 1
        self._start(asked, self._fit, self._made, camera, rectangle, asked)

    def change_kind(self, number: int, asked: AskedElement) -> None:
        """Starts to fit another shape to the points of an element; does nothing if it is gone.

        Raises:
            OperationError: another one is being fitted.
        """
        if (one := self._content.elements.get(number)) is not None:
            self._start(asked, self._fit, number, one.camera, one.rectangle, asked)

    def relate(self, first: int, second: int) -> None:
        """Starts to measure between two elements.

        Raises:
            OperationError: they are not two elements, or another one is being fitted.
        """
        if first == second or not {first, second} <= set(self._content.elements):
            raise OperationError(
                "no-two-elements", message("view-choose-two-elements"), message("view-element-gone")
            )
        self._made += 1
        self._start("relation", self._relate, self._made, first, second)

    def remove(self, number: int) -> None:
        """Removes an element with its dimensions, or a dimension; does nothing if it is gone."""
        left = self._content.without(number)
        if len(left.elements) + len(left.relations) < (
            len(self._content.elements) + len(self._content.relations)
        ):
            self._change(left)

    def undo(self) -> None:
        """Takes the last change back; does nothing if there is none."""
        if self._before:
            self._show(self._before.pop())

    def _start(self, asked: Work, work: Callable[..., None], *what: object) -> None:
        if self.busy:
            raise OperationError("busy", self.busy, remedy=message("wait-until-done"))
        self.busy = message("fitting", shape=asked)
        self._fitter.submit(self._run, asked, work, *what)
        self._changed()

    def _run(self, asked: Work, work: Callable[..., None], *what: object) -> None:
        """Runs in the fitter's thread."""
        try:
            work(*what)
        except OperationError as refusal:
            text = message("no-fitted", shape=asked, error=refusal.text)
            self._bus.event("refused", text, "attention")
        except Exception:
            log.exception("an element could not be fitted")
            self._bus.event("refused", message("no-fitted-program-failed", shape=asked), "bad")
        finally:
            with self._lock:
                self.busy = ""
                self._changed()

    def _fit(
        self, number: int, camera: ViewCamera, rectangle: Rectangle, asked: AskedElement
    ) -> None:
        from crenel.station.view3d.elements.measuring import (
            describe_element,
            describe_relation,
            element_mesh,
            measure_pick,
        )

        begun = self._scene.begun
        measured, picked = measure_pick(camera, rectangle, asked, self._scans())
        view = describe_element(number, measured, picked)
        made = _Element(view, measured, element_mesh(measured), camera, rectangle)
        with self._lock:
            if begun != self._scene.begun:
                return
            content = self._content
            elements = {**content.elements, number: made}
            relations = {
                key: one
                if number not in (one.first, one.second)
                else describe_relation(
                    key,
                    (one.first, one.second),
                    [elements[one.first].measured, elements[one.second].measured],
                )
                for key, one in content.relations.items()
            }
            self._change(_Content(elements, relations))

    def _relate(self, number: int, first: int, second: int) -> None:
        from crenel.station.view3d.elements.measuring import describe_relation

        with self._lock:
            elements = self._content.elements
            pair = [elements[one].measured for one in (first, second) if one in elements]
        if len(pair) < 2:  # one of them was removed in the meantime
            return
        made = describe_relation(number, (first, second), pair)
        with self._lock:
            content = self._content
            if {first, second} <= set(content.elements):
                others = {
                    key: one
                    for key, one in content.relations.items()
                    if {one.first, one.second} != {first, second}
                }
                self._change(_Content(content.elements, {**others, number: made}))

    def _change(self, new: _Content) -> None:
        self._before = [*self._before[1 - MOST_UNDONE :], self._content]
        self._show(new)

    def _show(self, new: _Content) -> None:
        """Draws what the new content has and the old one has not."""
        old = self._content.elements
        for number, one in old.items():
            if new.elements.get(number) is not one:
                self._scene.hide_shape(number)
        for number, one in new.elements.items():
            if old.get(number) is not one:
                label = f"{one.view.shape.capitalize()} {number}"
                self._scene.show_shape(number, one.mesh, label)
        self._content = new
        self._changed()
