"""The simulated operator, who does a step's work on the simulated station for all to watch."""

from collections.abc import Sequence
from typing import Protocol

from crenel.metrology.transforms import Floats


class SimulatedOperator(Protocol):
    """Moves the arm and presses its buttons.

    Every move blocks until it is done, and returns False when it was cancelled.
    """

    @property
    def faces(self) -> Sequence[str]: ...
    @property
    def parts(self) -> Sequence[str]: ...

    def touch(self, face: str, index: int) -> bool:
        """Touches one of the face's places and presses the primary button.

        Of a face of the block, or of a chessboard's printed side, "board".
        """

    def hold_over(self, name: str, view: int = 0) -> bool:
        """Brings the sensor over the "block" or the "board" and holds it still.

        ``view``: in which of the ways that a calibration on a chessboard wants.
        """

    def hold_at(self, q_rad: Sequence[float]) -> bool:
        """Brings the arm to joint angles, the sensor over the object, and holds it still."""

    def hold_flange_at(self, T_arm_flange: Floats) -> bool:
        """Brings the flange to a pose (4, 4), the sensor over the object, and holds it still."""

    def scan_part(self, name: str) -> bool:
        """Sweeps the sensor over the part."""

    def pass_over_plate(self) -> bool:
        """Goes over a flat plate, nearer and away again, as a delay is found by."""

    def go_to_seat(self, seat: int, posture: int = 0) -> bool:
        """Puts the tip into the ``seat``-th of the seats that stand about the reach.

        Another ``posture``: the elbow on another side, the wrist turned over.
        """

    @property
    def bar_mm(self) -> float:
        """The length of the ball bar that ``go_to_bar`` goes to."""

    @property
    def ball_mm(self) -> float:
        """The diameter of the sphere that ``touch_ball`` touches."""

    def go_to_bar(self, position: int, end: int, posture: int = 0) -> bool:
        """Puts the tip into an end (0 or 1) of the ball bar, for its ``position``-th place."""

    def touch_ball(self, ball: int, index: int) -> bool:
        """Touches the sphere in its ``ball``-th place and presses the primary button."""

    def touch_gauge(self, name: str, index: int) -> bool:
        """Touches the plate or the sphere on the table at its ``index``-th place, and presses
        the primary button."""

    def touch_sphere(self, outward: Sequence[float], stylus_from: Sequence[float]) -> bool:
        """Touches the sphere on the table at the place in a direction (3,) from its centre, with
        the stylus from another (3,), and presses the primary button; arm frame."""

    def touch_length(
        self, middle_mm: Sequence[float], along: Sequence[float], length_mm: float, end: int
    ) -> bool:
        """Touches an end (0 or 1) of a length of the step gauge, which is set up about a middle
        (3,) along a direction (3,), and presses the primary button; arm frame."""

    def touch_bar(
        self, middle_mm: Sequence[float], along: Sequence[float], end: int, touch: int
    ) -> bool:
        """Touches the sphere at an end (0 or 1) of the ball bar, which is set up about a middle
        (3,) along a direction (3,), at one of four places, and presses the primary button; arm
        frame."""

    def scan_bar(
        self, middle_mm: Sequence[float], along: Sequence[float], slowness: float = 1.0
    ) -> bool:
        """Passes the sensor over both spheres of the ball bar, which is set up likewise; by
        ``slowness`` slower than usual."""

    def scan_sphere(self, seen_from: Sequence[float], slowness: float = 1.0) -> bool:
        """Passes the sensor over the sphere on the table, which it sees from a direction (3,),
        arm frame; by ``slowness`` slower than usual."""

    def scan_plate(self, orientation: int) -> bool:
        """Sets a flat plate up and passes the sensor over it in strips, in its first or second
        ``orientation``."""

    def touch_seat(self, centre_mm: Sequence[float], number: int) -> bool:
        """Puts the tip into a seat at a place (3,), arm frame, with the arm articulated in the
        ``number``-th way, and presses the primary button."""

    def touch_part(self, feature: str, index: int) -> bool:
        """Touches the example part on the table at the ``index``-th place of a feature of its
        program, and presses the primary button."""

    def swing_in_seat(self) -> bool:
        """Swings the arm about the tip, which stays where it is."""

    def cancel(self) -> None:
        """Ends the move under way early."""
