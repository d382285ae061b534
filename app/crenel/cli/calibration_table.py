"""What an operator wants to know of a new calibration, as names and values to print."""

import numpy as np

from crenel.formats.results.calibration import CalibrationFile, PosePart, ResidualsPart, Uncertainty


def calibration_summary(document: CalibrationFile) -> list[tuple[str, str]]:
    """The verdict and its reasons, uncertainty, residuals, lens and probe matrix."""
    figures: list[tuple[str, str]] = []
    if document.verdict:
        figures.append(("verdict", document.verdict.quality))
        for finding in document.verdict.findings:
            mark = "" if finding.quality in ("good", "neutral") else f"{finding.quality.upper()}: "
            figures.append(("", f"{mark}{finding.text!s} {finding.remedy!s}"))
    if document.uncertainty:
        figures += _uncertainty_figures(document.uncertainty)
    if document.residuals:
        figures += _residual_figures(document.residuals)
    figures += [_pose_figure(pose) for pose in document.poses]
    if document.channel is not None:
        figures.append(("channel of the pictures", str(document.channel)))
    k1, k2, p1, p2, k3 = document.camera.distortion
    used = [
        f"{name} {value:+.5f}"
        for name, value in (("k1", k1), ("k2", k2), ("p1", p1), ("p2", p2), ("k3", k3))
        if value
    ]
    figures.append(("lens", ", ".join(used) or "no distortion"))
    if document.condition_number is not None:
        figures.append(("condition number", f"{document.condition_number:.1f} (refused above 50)"))
    for title, row in zip(("probe matrix", "", ""), document.probe_matrix, strict=False):
        figures.append((title, "".join(f"{value:12.6f}" for value in row)))
    return figures


def _uncertainty_figures(uncertainty: Uncertainty) -> list[tuple[str, str]]:
    near_mm, far_mm = uncertainty.depth_range_mm
    figures = [("uncertainty of a point", f"{uncertainty.total_um:.1f} µm (k = 1)")]
    figures += [(f"  {row.source}", f"{row.value_um:.1f} µm") for row in uncertainty.budget]
    if uncertainty.plane is not None:
        plane = uncertainty.plane
        figures.append(
            ("  a plane", f"{plane.angle_arcsec:.0f}″, {plane.offset_um:.1f} µm (k = 1)")
        )
    return [*figures, ("depth range", f"{near_mm:.1f} to {far_mm:.1f} mm from the camera")]


def _residual_figures(residuals: ResidualsPart) -> list[tuple[str, str]]:
    figures = [("edges and corners", f"{residuals.reprojection_rms_px:.3f} px rms")]
    if residuals.corners_px:
        corners = f"{len(residuals.corners_px)}, {_rms_px(residuals):.3f} px rms"
        figures.append(("corners", corners))
    stripe = "none yet"
    if residuals.laser_plane_rms_um is not None:
        stripe = f"{residuals.laser_plane_rms_um:.1f} µm rms of {residuals.stripe_points} points"
    figures.append(("laser plane", stripe))
    if residuals.contacts_um:
        left_out = len(residuals.contacts_left_out)
        contacts = f"{residuals.contacts_rms_um:.1f} µm rms of {len(residuals.contacts_um)}"
        excluded = f", {left_out} excluded" if left_out else ""
        figures.append(("contact points", contacts + excluded))
    for face in residuals.faces:
        form = f"{face.rms_um:6.1f} µm rms, form {face.form_um:.1f} µm, {face.points} points"
        figures.append((f"  {face.face}", form))
    return figures


def _rms_px(residuals: ResidualsPart) -> float:
    values = np.array(list(residuals.corners_px.values()))
    return float(np.sqrt(np.mean(np.sum(values**2, axis=1)))) if len(values) else 0.0


def _pose_figure(pose: PosePart) -> tuple[str, str]:
    if not pose.used:
        return f"  pose {pose.number}", f"excluded: {pose.reason!s}"
    stripe = f"stripe {pose.stripe_rms_px:.3f} px" if pose.stripe_points else "no stripe"
    fits = f"edges {pose.edges_rms_px:.3f} px, {stripe}, object off by {pose.off_um:.0f} µm"
    return f"  pose {pose.number}", fits + (f"; {pose.reason!s}" if pose.reason else "")
