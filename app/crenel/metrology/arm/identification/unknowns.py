"""The unknowns of the adjustment of an arm."""

from dataclasses import dataclass, replace

from crenel.metrology.arm.identification.observations import TIP, Marker, StackedObservations
from crenel.metrology.arm.kinematics import Arm, Tip
from crenel.metrology.transforms import Floats, rotation_from_vector, se3_exp


@dataclass(frozen=True)
class Unknowns:
    """All unknowns of the adjustment."""

    arm: Arm
    centres_mm: Floats
    """(P, 3) centre of each place, arm frame."""
    radius_excess_mm: float
    """How much larger the spheres are measured than the radii of sphere and tip state."""
    bar_errors_mm: Floats
    """(B,) of each artefact: true minus calibrated length."""
    T_arm_frames: Floats
    """(F, 4, 4) from the frame of each instrument to that of the arm."""
    offsets_mm: Floats
    """(K, 3) of each marker in the flange frame; the arm has that of the tip."""
    R_flange_markers: Floats
    """(K, 3, 3) rotation of each marker in the flange frame, if it has one."""

    def arm_with(self, index: int, marker: Marker) -> Arm:
        """The arm with this marker for its tip."""
        if marker.name == TIP:
            return self.arm
        x, y, z = (float(one) for one in self.offsets_mm[index])
        tip = Tip(x, y, z, self.arm.tip.diameter_mm)
        return replace(self.arm, tip=tip)

    def change_others(self, data: StackedObservations, change: Floats) -> "Unknowns":
        """After a change (``data.others.count``,) of what is no parameter of the arm."""
        others = data.others
        frames, offsets = self.T_arm_frames.copy(), self.offsets_mm.copy()
        rotations = self.R_flange_markers.copy()
        for i, own in enumerate(others.frames):
            if own is not None:
                frames[i] = se3_exp(change[own]) @ frames[i]
        for i, own in enumerate(others.offsets):
            if own is not None:
                offsets[i] += change[own]
        for i, own in enumerate(others.rotations):
            if own is not None:
                rotations[i] = rotation_from_vector(change[own]) @ rotations[i]
        by_mm = 0.0 if others.radius is None else float(change[others.radius])
        return replace(
            self,
            radius_excess_mm=self.radius_excess_mm + by_mm,
            bar_errors_mm=self.bar_errors_mm + change[others.bars],
            T_arm_frames=frames,
            offsets_mm=offsets,
            R_flange_markers=rotations,
        )
