"""The evaluation of the one-sphere test: its figures over all positions of the sphere."""

from collections.abc import Mapping, Sequence

import numpy as np

from crenel.errors import OperationError
from crenel.gauges.judgement.document import ImpliedOffsetPart
from crenel.gauges.judgement.evaluate import K, Measured, refuse
from crenel.gauges.judgement.evaluate_kind import Evaluated, Evaluation
from crenel.gauges.judgement.evaluate_measured_data import MeasuredData
from crenel.gauges.judgement.maths_value_uncertainty import (
    SphereCertificate,
    form_uncertainty_um,
    size_uncertainty_um,
)
from crenel.gauges.plan.document import PerformancePlan, SpherePart, sphere_features
from crenel.gauges.plan.document_symbols import SPHERE_QUANTITIES, Quantity
from crenel.gauges.plan.evaluate_artefacts import unknown_form
from crenel.gauges.sphere.evaluate import find_loose, find_unfinished, measure_position
from crenel.gauges.sphere.evaluate_position import (
    PositionResult,
    bring_sizes_to_20,
    largest_form_effect,
    name_causes,
    problems_of,
    sphere_certificate,
    sphere_uncertainty_um,
    worst,
)
from crenel.gauges.sphere.maths_location import ImpliedOffset, estimate_offset
from crenel.messages.limits import beside_limit
from crenel.messages.message import Text, message, quantity

BY_FORM: tuple[Quantity, ...] = ("form-touch", "form-scan", "dispersion-scan", "form-both")
"""Whose test value uncertainty is that of the sphere's form."""
MOVED_BY_SCATTER = 3.8
"""How many standard deviations of a touch the centres by 25 and by 5 touches are apart at most in
997 of 1000 spheres that stand still: simulated."""


class SphereEvaluation(Evaluation):
    """The evaluation of the one-sphere test."""

    def artefact(self, plan: PerformancePlan) -> SpherePart | None:
        return plan.sphere

    def features(self, plan: PerformancePlan) -> list[str]:
        return sphere_features(plan.positions)

    def unknown(self, plan: PerformancePlan) -> Mapping[Quantity, Text]:
        """The forms, if the certificate of the sphere states no own."""
        why = unknown_form(plan.sphere, plan.sphere.name) if plan.sphere else ""
        return dict.fromkeys(BY_FORM, why) if why else {}

    def notes(self, plan: PerformancePlan, filtered: bool) -> list[Text]:
        gate = plan.gate
        notes: list[Text] = [] if filtered else [message("performance-no-filter")]
        notes.append(
            message(
                "performance-gate",
                shell=quantity(gate.shell_mm, "mm", 1),
                incidence=quantity(gate.incidence_deg, "°"),
                cone=quantity(gate.cone_deg, "°"),
            )
        )
        if plan.positions == 1:
            notes.append(message("performance-one-position"))
        return notes

    def measure(self, data: MeasuredData, problems: list[Text]) -> Evaluated:
        plan = data.plan
        assert plan.sphere is not None, "a plan of this kind has a sphere"
        certificate = sphere_certificate(plan.sphere)
        off_c, sd_c = data.off_20_c
        results = [measure_position(data, plan.sphere, i + 1) for i in range(plan.positions)]
        for result in results:
            bring_sizes_to_20(result, plan.sphere, off_c)
        moved_um = max(result.moved_um for result in results)
        problems += _find_moved(results, certificate)
        problems += [text for result in results for text in find_loose(data, result)]
        problems += find_unfinished(data, results)
        of_unknown_form = self.unknown(plan)
        measured = [
            Measured(
                of,
                worst(results, of),
                tuple(
                    None if of not in one.values_mm else 1e3 * one.values_mm[of] for one in results
                ),
                None
                if of in of_unknown_form
                else sphere_uncertainty_um(
                    of, certificate, moved_um, largest_form_effect(results, of), sd_c, off_c
                ),
                problems_of(results, of),
                tuple(name for one in results for name in one.data.get(of, ())),
            )
            for of in SPHERE_QUANTITIES
        ]
        spheres = tuple(result.measurement(stated=not problems) for result in results)
        # where no location is stated, nothing follows from it either
        is_located = not problems and worst(results, "location-scan") is not None
        offset = _find_offset(results) if is_located else None
        notes = [note for result in results for note in result.notes]
        if not problems:
            size_um = size_uncertainty_um(certificate, sd_c, off_c)
            for result in results:
                causes = name_causes(result, size_um)
                notes += [_at_position(text, result, len(results)) for text in causes]
        part = None if offset is None else _offset_part(offset)
        refused = tuple(refuse(one, problems) for one in measured)
        return Evaluated(refused, spheres, part, notes=tuple(notes))


def _find_moved(results: Sequence[PositionResult], certificate: SphereCertificate) -> list[Text]:
    """Where the sphere moved by more than its certificate and the arm's own scatter make of two
    centres, hardly ever more."""
    still_um = K * max(form_uncertainty_um(certificate), size_uncertainty_um(certificate)) / 2
    found: list[Text] = []
    for result in results:
        limit_um = max(still_um, MOVED_BY_SCATTER * 1e3 * result.touch_sd_mm)
        if result.moved_um <= limit_um:
            continue
        moved, limit = beside_limit(result.moved_um, limit_um, "µm", 1)
        text = message("sphere-or-arm-moved", moved=moved, limit=limit)
        found.append(_at_position(text, result, len(results)))
    return found


def _at_position(text: Text, result: PositionResult, count: int) -> Text:
    """What is said of one of so many positions of the sphere."""
    if count == 1:
        return text
    return message("at-position", position=result.position, text=text)


def _find_offset(results: Sequence[PositionResult]) -> ImpliedOffset | None:
    """The probe matrix's error that the location error implies, of the position that counts."""
    result = max(results, key=lambda one: one.values_mm["location-scan"])
    if result.centres_mm is None or result.R_arm_sensor is None:
        return None
    try:
        return estimate_offset(result.centres_mm, result.R_arm_sensor, result.tactile_sd_mm)
    except OperationError:
        return None


def _offset_part(found: ImpliedOffset) -> ImpliedOffsetPart:
    x, y, z = (float(value) for value in found.offset_mm)
    sx, sy, sz = (float(value) for value in np.sqrt(np.diag(found.covariance)))
    known = {
        "size": quantity(1e3 * found.size_mm, "µm"),
        "left": quantity(1e3 * found.left_mm, "µm"),
    }
    return ImpliedOffsetPart(
        offset_mm=(x, y, z),
        standard_uncertainty_mm=(sx, sy, sz),
        significant=found.is_significant,
        left_um=1e3 * found.left_mm,
        text=message("offset-worth-calibrating", **known)
        if found.is_significant
        else message("offset-not-significant", **known),
    )
