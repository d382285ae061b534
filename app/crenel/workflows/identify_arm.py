"""From a folder of seats, spheres, ball bars and coordinates to an identified ``arm.json``."""

import os
from contextlib import nullcontext
from dataclasses import asdict, dataclass
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from crenel.formats.atomic_write import check_output_path
from crenel.formats.datasheets.arm import ArmFile, arm_document
from crenel.formats.datasheets.arm_identification import (
    CorrelationPart,
    DeviationsPart,
    FixedParameterPart,
    FramePart,
    IdentificationInput,
    IdentificationPart,
    MarkerPart,
    ParameterPart,
    ValidationPart,
)
from crenel.formats.io_errors import prefix_errors
from crenel.formats.json_document import SOFTWARE, file_sha256
from crenel.formats.session.arm_session import (
    TABLES,
    read_identification_session,
    read_observations,
)
from crenel.messages.message import Text, message, quantity
from crenel.metrology.arm.identification.cross_validation import Deviations, Validation
from crenel.metrology.arm.identification.identify import (
    FoundFrame,
    FoundMarker,
    Identification,
    Outlier,
    identify,
)
from crenel.metrology.arm.identification.parameter_selection import REASONS, FixedReason
from crenel.metrology.transforms import Floats
from crenel.progress import Progress, no_progress


@dataclass(frozen=True)
class IdentificationProvenance:
    """Where and by whom an arm is identified, as far as it is known."""

    operator: str = ""
    station: str = ""
    simulated: bool = False
    temperature_c: float | None = None


def identify_folder(
    folder: Path,
    output: Path,
    check: Path | None = None,
    progress: Progress = no_progress,
    signature: IdentificationProvenance = IdentificationProvenance(),
    names_folder: bool = True,
) -> tuple[ArmFile, Identification]:
    """Identifies the arm of a folder and writes it to ``output``.

    Args:
        check: a folder of places that the fit must not see.
        signature: what the file says of where and by whom it was made.
        names_folder: errors of the data begin with the folder, which a browser does not show.

    Raises:
        OperationError: the folder or the place to write to is not in order, or no better arm
            follows from it; nothing is then written.
    """
    check_output_path(output)
    session = read_identification_session(folder)
    held_out = None if check is None else read_observations(check, session.arm)
    inputs = [*session.files]
    if check is not None:
        inputs += [check / name for name in TABLES if (check / name).exists()]
    check_output_path(output, inputs)
    with prefix_errors(folder) if names_folder else nullcontext():
        result = identify(session.arm, session.observations, held_out, progress)
    document = arm_document(result.arm, identification_part(result, inputs, folder, signature))
    document.write(output)
    return document, result


def identification_part(
    result: Identification, inputs: list[Path], folder: Path, signature: IdentificationProvenance
) -> IdentificationPart:
    """What the file says of an identification, made now."""
    return IdentificationPart(
        created_at=datetime.now(UTC).isoformat(timespec="seconds"),
        **asdict(signature),
        parameters=tuple(
            ParameterPart(
                name=_in_degrees(moved.name),
                before=moved.before * _scale(moved.name),
                after=moved.after * _scale(moved.name),
                standard_uncertainty=moved.standard_uncertainty * _scale(moved.name),
            )
            for moved in result.changes
        ),
        covariance=tuple(tuple(row) for row in _covariance_in_degrees(result).tolist()),
        held=tuple(
            FixedParameterPart(name=_in_degrees(h.name), reason=h.why) for h in result.fixed
        ),
        correlated=tuple(
            CorrelationPart(first=first, second=second, coefficient=rho)
            for first, second, rho in strong_correlations(result)
        ),
        volume_before_um=result.volume_before_mm * 1e3,
        volume_after_um=result.volume_after_mm * 1e3,
        size_known=result.size_known,
        scatter_um=result.scatter.touch_mm * 1e3 if result.touched else None,
        coordinates_scatter_um=result.scatter.point_mm * 1e3 if result.markers else None,
        rotations_scatter_deg=float(np.rad2deg(result.scatter.turn_rad))
        if any(marker.rotation is not None for marker in result.markers)
        else None,
        frames=tuple(_frame_part(frame) for frame in result.frames),
        markers=tuple(_marker_part(marker) for marker in result.markers),
        validation=_validation_part(result.validation),
        outliers=tuple(outlier_text(outlier) for outlier in result.outliers),
        warnings=result.warnings,
        inputs=tuple(
            IdentificationInput(
                file=Path(os.path.relpath(path, folder)).as_posix(), sha256=file_sha256(path)
            )
            for path in inputs
        ),
        software=SOFTWARE,
    )


def _frame_part(frame: FoundFrame) -> FramePart:
    from scipy.spatial.transform import Rotation  # slow to import, and seldom needed

    x, y, z = frame.T_frame_arm[:3, 3].tolist()
    qx, qy, qz, qw = Rotation.from_matrix(frame.T_frame_arm[:3, :3]).as_quat().tolist()
    return FramePart(
        name=frame.name,
        x_mm=x,
        y_mm=y,
        z_mm=z,
        qx=qx,
        qy=qy,
        qz=qz,
        qw=qw,
        standard_uncertainty_mm=frame.standard_uncertainty_mm,
    )


def _marker_part(marker: FoundMarker) -> MarkerPart:
    from scipy.spatial.transform import Rotation

    x, y, z = marker.offset_mm.tolist()
    sds, rotation = marker.standard_uncertainty_mm, marker.rotation
    return MarkerPart(
        name=marker.name,
        x_mm=x,
        y_mm=y,
        z_mm=z,
        standard_uncertainty_mm=None if sds is None else tuple(sds.tolist()),
        quaternion=None
        if rotation is None
        else tuple(Rotation.from_matrix(rotation).as_quat().tolist()),
    )


def outlier_text(outlier: Outlier) -> Text:
    """One point that was left out."""
    far_mm = outlier.distance_mm
    far = quantity(1e3 * far_mm, "µm") if far_mm < 1.0 else quantity(far_mm, "mm", 1)
    if outlier.is_coordinate:
        return message(
            "coordinate-left-out-off", place=outlier.place, number=outlier.number, distance=far
        )
    return message("point-left-out-off", place=outlier.place, number=outlier.number, distance=far)


def identification_summary(result: Identification) -> list[tuple[str, str]]:
    """What an operator wants to know of an identification: names and values to print."""
    before, after = result.validation.before, result.validation.after
    kind = "of a separate set" if result.validation.separate else "left out in turn"
    figures = [
        (
            "tip over the reach",
            f"error {result.volume_before_mm * 1e3:.0f} µm rms before; standard uncertainty now "
            f"{result.volume_after_mm * 1e3:.1f} µm (k = 1)"
            + ("" if result.size_known else ", without the arm's scale"),
        ),
        (f"on {result.validation.places} places {kind}", "before       after"),
    ]
    for title, was, now in (
        ("  seats", before.seats_um, after.seats_um),
        ("  spheres", before.spheres_um, after.spheres_um),
        ("  lengths of ball bars", before.lengths_um, after.lengths_um),
        ("  measured coordinates", before.coordinates_um, after.coordinates_um),
    ):
        if was is not None and now is not None:
            figures.append((title, f"{was:8.1f} µm {now:8.1f} µm rms"))
    if before.rotations_deg is not None and after.rotations_deg is not None:
        was, now = before.rotations_deg, after.rotations_deg
        figures.append(("  measured rotations", f"{was:8.4f} °  {now:8.4f} °  rms"))
    figures.append(
        ("  in standard deviations", f"{before.normalised:8.1f}    {after.normalised:8.2f}")
    )
    if result.touched:
        scatter = f"{result.scatter.touch_mm * 1e3:.1f} µm per coordinate"
        figures.append(("scatter beyond the encoders", scatter))
    if result.markers:
        scatter = f"{result.scatter.point_mm * 1e3:.1f} µm per coordinate"
        figures.append(("coordinates, beyond what is stated", scatter))
    figures += _instrument_figures(result)
    if result.radius_excess_sd_mm is not None:
        sd_um = 2e3 * result.radius_excess_sd_mm
        figures.append(
            ("measured sphere diameters", f"{2e3 * result.radius_excess_mm:+.1f} ± {sd_um:.1f} µm")
        )
    for k, outlier in enumerate(result.outliers):
        figures.append(("excluded" if k == 0 else "", str(outlier_text(outlier))))
    return figures


def _instrument_figures(result: Identification) -> list[tuple[str, str]]:
    """Where the arm's base is in each frame, and each marker on the flange."""
    figures: list[tuple[str, str]] = []
    for frame in result.frames:
        x, y, z = frame.T_frame_arm[:3, 3]
        sd = frame.standard_uncertainty_mm
        known = "as given" if sd is None else f"± {sd:.3f} mm"
        figures.append((f"base in frame {frame.name}", f"{x:.3f}, {y:.3f}, {z:.3f} mm, {known}"))
    for marker in result.markers:
        x, y, z = marker.offset_mm
        figures.append((f"marker {marker.name} on the flange", f"{x:.3f}, {y:.3f}, {z:.3f} mm"))
    return figures


def parameter_lines(result: Identification) -> list[dict[str, str | float]]:
    """Each parameter moved, in the file's units: name, unit, before, after, uncertainty."""
    return [
        {
            "name": _in_degrees(moved.name),
            "unit": "°" if moved.name.endswith("_rad") else "mm",
            "before": moved.before * _scale(moved.name),
            "after": moved.after * _scale(moved.name),
            "standard_uncertainty": moved.standard_uncertainty * _scale(moved.name),
        }
        for moved in result.changes
    ]


def parameter_rows(result: Identification) -> list[list[str]]:
    """The same to print: name, before, after, change and standard uncertainty."""
    rows: list[list[str]] = []
    for moved in result.changes:
        scale = _scale(moved.name)
        before, after = moved.before * scale, moved.after * scale
        decimals = 6 if moved.name.endswith("_rad") else 4
        rows.append(
            [
                _in_degrees(moved.name),
                f"{before:.{decimals}f}",
                f"{after:.{decimals}f}",
                f"{after - before:+.{decimals}f}",
                f"{moved.standard_uncertainty * scale:.{decimals}f}",
            ]
        )
    return rows


def list_fixed_parameters(result: Identification) -> list[tuple[str, Text]]:
    """The D-H parameters that kept their values, by reason."""
    by_reason: dict[FixedReason, list[str]] = {}
    for held in result.fixed:
        if ".error." not in held.name or held.reason in ("redundant", "unobserved"):
            by_reason.setdefault(held.reason, []).append(_in_degrees(held.name))
    return [(", ".join(names), REASONS[reason]) for reason, names in by_reason.items()]


def strong_correlations(result: Identification) -> list[tuple[str, str, float]]:
    """Pairs of moved parameters that the places hardly distinguish, by the file's names."""
    return [(_in_degrees(a), _in_degrees(b), rho) for a, b, rho in result.correlations]


def correlation_figures(result: Identification) -> list[tuple[str, str]]:
    """The same to print."""
    return [(f"{a}, {b}", f"{rho:+.3f}") for a, b, rho in strong_correlations(result)]


def _validation_part(validation: Validation) -> ValidationPart:
    return ValidationPart(
        method="separate" if validation.separate else "cross-validation",
        places=validation.places,
        before=_deviations_part(validation.before),
        after=_deviations_part(validation.after),
    )


def _deviations_part(deviations: Deviations) -> DeviationsPart:
    return DeviationsPart(**asdict(deviations))


def _in_degrees(name: str) -> str:
    return name.removesuffix("_rad") + "_deg" if name.endswith("_rad") else name


def _scale(name: str) -> float:
    return float(np.rad2deg(1.0)) if name.endswith("_rad") else 1.0


def _covariance_in_degrees(result: Identification) -> Floats:
    scales = np.array([_scale(moved.name) for moved in result.changes])
    return np.asarray(result.covariance * np.outer(scales, scales))
