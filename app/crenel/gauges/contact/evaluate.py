"""The contact tests of ASME B89.4.22: effective diameter, articulation in seats, volume."""

from collections.abc import Mapping, Sequence

import numpy as np

from crenel.errors import OperationError
from crenel.formats.results.calibration import Calibration
from crenel.gauges.contact.maths import (
    PLACEMENTS,
    SEAT_POINTS,
    SEATS,
    SPHERE_POINTS,
    SPHERES,
    effective_diameter,
    volumetric_length,
    volumetric_uncertainty_um,
)
from crenel.gauges.judgement.evaluate import Measured, refuse
from crenel.gauges.judgement.evaluate_kind import Evaluated, Evaluation
from crenel.gauges.judgement.evaluate_loose_artefacts import (
    loose_bar_problems,
    loose_seat_problems,
    loose_sphere_problems,
    steady_scatter_um,
)
from crenel.gauges.judgement.evaluate_measured_data import MeasuredData
from crenel.gauges.judgement.maths_value_uncertainty import (
    DIAMETER_BY_FORM_OF_NINE,
    size_uncertainty_um,
)
from crenel.gauges.plan.document import PerformancePlan
from crenel.gauges.plan.document_length_standard import LengthStandardFile
from crenel.gauges.plan.evaluate_artefacts import Artefact, problems_of_artefact
from crenel.gauges.plan.maths_length_places import SEAT_SHARES, arm_reach, reach_share
from crenel.gauges.plan.maths_lengths import MeasuredLength, length_of_bar_mm
from crenel.gauges.plan.maths_temperature import MeanTemperature
from crenel.gauges.sphere.evaluate_position import sphere_certificate
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.kinematics import AnyArm, tip_of
from crenel.metrology.fitting.reference_sphere import sphere_centre
from crenel.metrology.probing.seat_articulation import seat_articulation
from crenel.metrology.transforms import Floats

LEAST_BAR_TOUCHES = 4
OFF_SHARE = 0.05
"""By how much a seat may be off the distance that the standard asks for, of the reach."""
OTHER_MM, OTHER_BAR_SHARE = 2.0, 0.005
"""A length that differs by more than both is that of another bar, a diameter that differs by more
than the first that of another sphere: no arm is so far off."""


def diameter_feature(number: int) -> str:
    """Touches of one measurement of the master sphere: ``d1``."""
    return f"d{number}"


def seat_feature(number: int) -> str:
    """Touches in one seat: ``s1`` near, ``s2`` in the middle, ``s3`` far."""
    return f"s{number}"


def bar_feature(placement: int, end: int) -> str:
    """Touches on an end (0 or 1) of the bar in one placement: ``b1-0``."""
    return f"b{placement}-{end}"


FEATURES: Mapping[str, tuple[str, ...]] = {
    "diameter": tuple(diameter_feature(i + 1) for i in range(SPHERES)),
    "seats": tuple(seat_feature(i + 1) for i in range(SEATS)),
    "bar": tuple(bar_feature(i + 1, end) for i in range(PLACEMENTS) for end in (0, 1)),
}
"""Groups of touches of each step, in their order."""


class ContactEvaluation(Evaluation):
    """The evaluation of the contact tests. Of several artefacts, each refuses its own figures."""

    def artefact(self, plan: PerformancePlan) -> Artefact | None:
        return plan.sphere or plan.length

    def check(self, plan: PerformancePlan) -> None:
        """The test may be done without an artefact."""

    def list_problems(
        self, plan: PerformancePlan, calibration: Calibration | None, arm: AnyArm | None
    ) -> list[Text]:
        return [] if self.artefact(plan) else [message("artefact-missing")]

    def features(self, plan: PerformancePlan) -> list[str]:
        return [name for names in FEATURES.values() for name in names]

    def measure(self, data: MeasuredData, problems: list[Text]) -> Evaluated:
        measured, of_artefacts = measure_contact_test(data)
        problems += of_artefacts
        return Evaluated(tuple(measured), notes=contact_notes(data))


def measure_contact_test(data: MeasuredData) -> tuple[list[Measured], list[Text]]:
    """Every figure that the touches allow, and why sphere or bar cannot serve, by their names.

    Only the figures of an artefact that cannot serve are without a value. Those of an artefact
    that was left out are not among them.
    """
    plan, calibration = data.plan, data.calibration
    # the reach is not checked: a bar across the arm's column may be longer, and it was touched
    of_sphere, of_bar = (
        [] if one is None else problems_of_artefact(one, plan, calibration)
        for one in (plan.sphere, plan.length)
    )
    loose_seats, loose_sphere, loose_bar = _find_loose(data)
    measured = [refuse(one, loose_seats) for one in _measure_seats(data)]
    of_sphere, of_bar = [*of_sphere, *loose_sphere], [*of_bar, *loose_bar]
    if not _lacks_sphere(data):
        measured.insert(0, refuse(_measure_diameter(data), of_sphere))
    if not _lacks_bar(data):
        measured += [refuse(one, of_bar) for one in _measure_volume(data)]
    unfinished = _find_unfinished(data)
    measured = [refuse(one, unfinished) for one in measured]
    named: list[Text] = [
        message("titled-text", title=artefact.name, text=problem)
        for artefact, problems in ((plan.sphere, of_sphere), (plan.length, of_bar))
        if artefact is not None
        for problem in problems
    ]
    return measured, [*unfinished, *loose_seats, *named]


def _find_unfinished(data: MeasuredData) -> list[Text]:
    """What a test that was stopped lacks of sphere, seats and bar, where none was left out."""
    of_sphere = "" if data.plan.sphere is None else _missing_of_sphere(data)
    of_bar = "" if data.plan.length is None else _missing_of_bar(data)
    return [text for text in (of_sphere, _missing_of_seats(data), of_bar) if text]


def _missing_of_sphere(data: MeasuredData) -> Text:
    """Why the master sphere has too few touches; empty if it has enough."""
    if _fewest(data, FEATURES["diameter"]) >= SPHERE_POINTS:
        return ""
    return message("master-sphere-not-measured", count=SPHERES, points=SPHERE_POINTS)


def _missing_of_seats(data: MeasuredData) -> Text:
    """Why the seats have too few touches; empty if they have enough."""
    if _fewest(data, FEATURES["seats"]) >= SEAT_POINTS:
        return ""
    return message("seats-not-measured", count=SEATS, points=SEAT_POINTS)


def _missing_of_bar(data: MeasuredData) -> Text:
    """Why the bar was measured in too few placements; empty if it was in all."""
    ends = ([bar_feature(i + 1, end) for end in (0, 1)] for i in range(PLACEMENTS))
    placed = sum(_fewest(data, names) >= LEAST_BAR_TOUCHES for names in ends)
    if placed == PLACEMENTS:
        return ""
    return message("bar-not-placed", count=placed, needed=PLACEMENTS)


def _fewest(data: MeasuredData, names: Sequence[str]) -> int:
    """The touches of the group that has the fewest."""
    return min(len(data.tips_mm.get(name, ())) for name in names)


def _find_loose(data: MeasuredData) -> tuple[list[Text], list[Text], list[Text]]:
    """Where seats, master sphere and bar give way while they are touched, by the scatter in the
    seats and in other placements."""
    tips, tip_mm = data.tips_mm, tip_of(data.arm).diameter_mm
    seats = [tips[name] for name in FEATURES["seats"] if name in tips]
    steady_um = steady_scatter_um(seats)
    spheres = [
        tips[name] for name in FEATURES["diameter"] if len(tips.get(name, ())) >= SPHERE_POINTS
    ]
    bar_mm = data.plan.length.sphere_diameter_mm if data.plan.length else None
    placed = {
        i + 1: [tips[name] for end in (0, 1) if (name := bar_feature(i + 1, end)) in tips]
        for i in range(PLACEMENTS)
    }
    return (
        [] if _missing_of_seats(data) else loose_seat_problems(seats),
        loose_sphere_problems(spheres, steady_um),
        []
        if bar_mm is None
        else loose_bar_problems(placed, (bar_mm + tip_mm) / 2, "contact", steady_um),
    )


def contact_notes(data: MeasuredData) -> tuple[Text, ...]:
    """Which artefacts were left out, and what is to be known of the seats."""
    left_out = [
        message("performance-left-out", which=which)
        for which, lacks in (("sphere", _lacks_sphere(data)), ("bar", _lacks_bar(data)))
        if lacks
    ]
    return (*left_out, *_seat_notes(data))


def _lacks_sphere(data: MeasuredData) -> bool:
    """Whether the master sphere was left out: none is named, and none was touched."""
    return data.plan.sphere is None and not any(one in data.tips_mm for one in FEATURES["diameter"])


def _lacks_bar(data: MeasuredData) -> bool:
    """Whether the ball bar was left out: none is named, and none was touched."""
    return data.plan.length is None and not any(one in data.tips_mm for one in FEATURES["bar"])


def seat_problem(number: int, share: float) -> Text:
    """Why a seat stands too far or too near; empty if it stands well.

    Args:
        number: of the seat, from 1.
        share: its distance from the shoulder as a share of the arm's reach.
    """
    near, _, far = SEAT_SHARES
    percent = round(100 * share)
    if number == 1 and share > near + OFF_SHARE:
        return message("performance-seat-not-near", share=percent, most=round(100 * near))
    if number == SEATS and share < far - OFF_SHARE:
        return message("performance-seat-not-far", share=percent, least=round(100 * far))
    return ""


def _seat_notes(data: MeasuredData) -> tuple[Text, ...]:
    """What is to be known of seats: that they have no certificate, and which do not stand where the
    standard asks for them; nothing is said of their places with an arm whose reach is not known."""
    if not any(name in data.tips_mm for name in FEATURES["seats"]):
        return ()
    uncertified = message("performance-seat-has-no-certificate")
    reach = arm_reach(data.arm)
    if not reach.known:
        return (uncertified,)
    groups = enumerate(map(data.tips_mm.get, FEATURES["seats"]), start=1)
    found = (
        seat_problem(number, reach_share(reach, tips.mean(axis=0)))
        for number, tips in groups
        if tips is not None
    )
    return (uncertified, *(text for text in found if text))


def _measure_diameter(data: MeasuredData) -> Measured:
    sphere = data.plan.sphere
    if sphere is None:
        problem = message("plan-without-artefact", which="master")
        return Measured("effective-diameter", None, problem=problem)
    names = FEATURES["diameter"]
    if missing := _missing_of_sphere(data):
        return Measured("effective-diameter", None, problem=missing)
    groups = [data.tips_mm[name] for name in names]
    off_c, sd_c = data.off_20_c
    growth = 1 + sphere.expansion_per_c * off_c
    try:
        found = effective_diameter(groups, tip_of(data.arm).diameter_mm, sphere.diameter_mm, growth)
    except OperationError as error:  # all touches in one place
        return Measured("effective-diameter", None, problem=error.what, data=names)
    sd_um = size_uncertainty_um(sphere_certificate(sphere), sd_c, off_c, DIAMETER_BY_FORM_OF_NINE)
    mean, each = found.mean_error_um, found.errors_um
    if abs(mean) > 1e3 * OTHER_MM:
        problem = message("other-sphere-measured", off=quantity(1e-3 * mean, "mm", 1))
        return Measured("effective-diameter", None, problem=problem, data=names)
    return Measured("effective-diameter", mean, each, sd_um, "", names)


def _measure_seats(data: MeasuredData) -> list[Measured]:
    names = FEATURES["seats"]
    if problem := _missing_of_seats(data):
        return [
            Measured("articulation-largest", None, problem=problem),
            Measured("articulation-two-s", None, problem=problem),
        ]
    found = [seat_articulation(data.tips_mm[name]) for name in names]
    largest = tuple(one.largest_um for one in found)
    two_s = tuple(one.two_s_um for one in found)
    return [
        Measured("articulation-largest", max(largest), largest, 0.0, "", names),
        Measured("articulation-two-s", max(two_s), two_s, 0.0, "", names),
    ]


def _measure_volume(data: MeasuredData) -> list[Measured]:
    standard = data.plan.length
    if standard is None or standard.kind != "ball-bar":
        return _without_volume(message("plan-without-artefact", which="bar"))
    if standard.sphere_diameter_mm is None:
        return _without_volume(message("bar-without-sphere-diameter"))
    lengths, names = bar_lengths(
        data.tips_mm, standard, tip_of(data.arm).diameter_mm, data.artefact
    )
    if other := _find_other_bar(lengths):
        return _without_volume(other)
    if missing := _missing_of_bar(data):
        return _without_volume(missing)
    deviations_um = np.array([one.error_um for one in lengths])
    found = volumetric_length(deviations_um.tolist())
    of_largest_um, of_rms_um = volumetric_uncertainty_um(
        deviations_um,
        np.array([one.certificate_uncertainty_um for one in lengths]),
        np.array([one.form_uncertainty_um for one in lengths]),
    )
    largest_um, each = found.largest_um, found.deviations_um
    return [
        Measured("volumetric-largest", largest_um, each, of_largest_um, "", tuple(names)),
        Measured("volumetric-two-rms", found.two_rms_um, (), of_rms_um, "", tuple(names)),
    ]


def _without_volume(problem: Text) -> list[Measured]:
    return [
        Measured("volumetric-largest", None, problem=problem),
        Measured("volumetric-two-rms", None, problem=problem),
    ]


def bar_lengths(
    tips_mm: Mapping[str, Floats],
    standard: LengthStandardFile,
    tip_diameter_mm: float,
    artefact: MeanTemperature | None,
) -> tuple[list[MeasuredLength], list[str]]:
    """The length in each placement both of whose ends were touched, beside the certified length
    that is nearest; and the groups of these touches.

    Args:
        tips_mm: tip centres (N, 3) by the feature of the touches.
        standard: a bar with spheres.
        artefact: temperature of the bar; None: not measured.
    """
    assert standard.sphere_diameter_mm is not None, "a bar has spheres"
    diameter_mm = standard.sphere_diameter_mm + tip_diameter_mm
    lengths: list[MeasuredLength] = []
    names: list[str] = []
    for placement in range(1, PLACEMENTS + 1):
        ends = [bar_feature(placement, end) for end in (0, 1)]
        groups: list[Floats] = [tips_mm.get(name, np.zeros((0, 3))) for name in ends]
        if any(len(tips) < LEAST_BAR_TOUCHES for tips in groups):
            continue
        length_mm = length_of_bar_mm(*(sphere_centre(tips, diameter_mm) for tips in groups))
        away_mm = [abs(part.length_mm - length_mm) for part in standard.lengths]
        nominal = standard.nominal(away_mm.index(min(away_mm)) + 1)
        lengths.append(MeasuredLength(placement, 1, nominal, length_mm, artefact))
        names += ends
    return lengths, names


def _find_other_bar(lengths: list[MeasuredLength]) -> Text:
    """The first length that is none of the certificate's; empty if all are."""
    for one in lengths:
        certified_mm = one.nominal.length_mm
        if abs(one.error_um) > 1e3 * max(OTHER_MM, OTHER_BAR_SHARE * certified_mm):
            return message(
                "other-bar-measured",
                placement=one.place,
                measured=quantity(one.measured_mm, "mm", 1),
                certified=quantity(certified_mm, "mm", 1),
            )
    return ""
