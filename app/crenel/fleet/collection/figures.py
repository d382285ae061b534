"""The results in the documents of a record, each as a symbol with its value."""

from crenel.fleet.catalogue.entry import EntryFigure
from crenel.formats.results.arm_checks import ArmCheckFile, TipCheckFile
from crenel.formats.results.calibration import CalibrationFile
from crenel.gauges.judgement.document import PerformanceFile
from crenel.gauges.quick.document import VerificationFile


def calibration_figures(
    document: CalibrationFile, limit_um: float | None
) -> tuple[EntryFigure, ...]:
    """How good it is, and where it says that laser plane, camera and sensor are.

    Args:
        limit_um: of the standard uncertainty of a point, by which the station judged it.
    """
    found = [
        _figure("focal-length-u", document.camera.matrix[0][0], "px"),
        _figure("focal-length-v", document.camera.matrix[1][1], "px"),
        *(
            _figure(f"probe-{axis}", row[3], "mm")
            for axis, row in zip("xyz", document.probe_matrix, strict=False)
        ),
    ]
    if document.uncertainty is not None:
        total_um = document.uncertainty.total_um
        found.append(_figure("point-uncertainty", total_um, "µm", limit=limit_um))
    if (left := document.residuals) is not None:
        found += [
            _figure("reprojection-rms", left.reprojection_rms_px, "px"),
            _figure("contacts-rms", left.contacts_rms_um, "µm"),
        ]
        if left.laser_plane_rms_um is not None:
            found.append(_figure("laser-plane-rms", left.laser_plane_rms_um, "µm"))
    if document.laser_plane is not None:
        found.append(_figure("laser-plane-offset", document.laser_plane.offset_mm, "mm"))
    return tuple(found)


def verification_figures(document: VerificationFile) -> tuple[EntryFigure, ...]:
    """Every figure of a gauge."""
    return tuple(
        EntryFigure(
            symbol=f"gauge-{one.name.replace('_', '-')}",
            quantity=f"gauge-{one.name.replace('_', '-')}",
            value=one.value,
            unit=one.unit,
            expanded_uncertainty=one.expanded_uncertainty,
            limit=one.limit,
            decision=one.decision,
        )
        for one in document.figures
    )


def performance_figures(document: PerformanceFile) -> tuple[EntryFigure, ...]:
    """Every symbol whose value is stated."""
    return tuple(
        EntryFigure(
            symbol=one.symbol,
            quantity=one.quantity,
            value=one.value,
            unit=one.unit,
            expanded_uncertainty=one.test_uncertainty,
            limit=one.limit,
            decision=one.decision,
        )
        for one in document.figures
        if one.value is not None
    )


def arm_check_figures(document: ArmCheckFile) -> tuple[EntryFigure, ...]:
    """The figures of a check of the tip's centre in one seat."""
    half_range_um = max(document.half_range_um)
    found = [
        _figure("arm-half-range", half_range_um, "µm", limit=document.limit_um),
        _figure("arm-two-sigma", max(document.two_sigma_um), "µm"),
    ]
    if document.largest_um is not None:
        found.append(_figure("arm-largest", document.largest_um, "µm"))
    return tuple(found)


def tip_check_figures(document: TipCheckFile) -> tuple[EntryFigure, ...]:
    """The figures of a check by a sphere that was touched."""
    error = EntryFigure(
        symbol="tip-diameter-error",
        quantity="tip-diameter-error",
        value=document.error_um,
        unit="µm",
        expanded_uncertainty=document.expanded_uncertainty_um,
        limit=document.limit_um,
        decision=document.decision,
    )
    return (error, _figure("tip-scatter", document.scatter_um, "µm"))


def _figure(quantity: str, value: float, unit: str, limit: float | None = None) -> EntryFigure:
    return EntryFigure(quantity, quantity, value, unit, limit=limit)
