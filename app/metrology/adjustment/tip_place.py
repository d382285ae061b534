"""Whether the probe's tip sits where the arm's file has it: a bent stylus, or another one.

Contacts with the wrist turned differently then disagree, which the errors of the arm's links
would take up: one is weighed against the other.
"""

from dataclasses import dataclass, replace

import numpy as np

from app.metrology.adjustment.linear import normal
from app.metrology.adjustment.link_sizes import likely_links
from app.metrology.adjustment.scales import Scales, size_prior
from app.metrology.adjustment.solve import Adjusted
from app.metrology.findings import Finding, Limits, grave
from app.metrology.frames import Floats

# Where a tip that is not where it should be may be, each way, before anything is told: bent,
# or another one; the one as likely as the other.
ASTRAY_MM = (0.1, 0.5)
# Twice the logarithm of how much likelier that is than that it is in its place: strong
# evidence (Kass and Raftery 1995); and nothing is said of less than so far.
EVIDENCE, LEAST_MM = 6.0, 0.03
# Sizes of the links' errors, as factors of those told, which a wrong tip makes too large; turns
# and shifts go together within so much (logarithms).
FACTORS = np.exp(np.linspace(-6.0, 1.5, 16))
TOGETHER = 1.6


@dataclass(frozen=True)
class TipPlace:
    """Where the tip's centre is against the arm's file, flange frame.

    ``evidence`` is twice the logarithm of how much likelier that is than the file's place.
    """

    off_mm: Floats  # (3,)
    covariance_mm2: Floats  # (3, 3)
    evidence: float


def about_tip_place(found: Adjusted, limits: Limits) -> list[Finding]:
    """Whether contacts and pictures speak for the tip's centre in another place."""
    told = tip_place(found)
    if told is None or told.evidence < EVIDENCE:
        return []
    off_mm = float(np.linalg.norm(told.off_mm))
    if off_mm < LEAST_MM:
        return []
    x, y, z = told.off_mm
    known_mm = 2 * float(np.sqrt(np.max(np.diag(told.covariance_mm2))))
    return [
        Finding(
            grave(off_mm, limits),
            "tip-place",
            f"Contacts and pictures agree better with the tip's centre {off_mm:.2f} mm from where "
            f"the arm's file has it: by {x:+.2f}, {y:+.2f}, {z:+.2f} mm (± {known_mm:.2f}) in the "
            "flange frame. Scanned points are off by about as much.",
            "Check which tip is mounted and that its stylus is straight and tight; have its place "
            "determined anew, and touch the object again.",
        )
    ]


def tip_place(found: Adjusted) -> TipPlace | None:
    """What the adjustment tells of the tip's place; None where nothing was touched.

    The tip's place is three more unknowns, taken as linear at the minimum. How large the
    links' errors are is weighed with it, as ``link_sizes.by_link_sizes`` does: with the tip
    set right they may be much smaller.
    """
    contacts, touches = found.linear.contacts, found.problem.touches
    if contacts is None or touches is None:
        return None
    equations, scales = normal(found.linear, found.judgements), found.scales
    at, start = equations.linear.at, equations.linear.state.links
    parts, _ = equations.with_scales(scales)
    N = np.sum([part for source, part in parts.items() if source != "links"], axis=0)
    links = np.arange(at.count)[at.links]
    others = np.setdiff1d(np.flatnonzero(found.free), links)
    normals = touches.normals @ equations.linear.state.T_arm_obj[:3, :3].T
    by_tip = np.einsum("ni,nij->nj", normals, touches.R_arm_flange)[touches.kept]
    weight = 1 / contacts.variances(scales)
    across = contacts.jacobian.T @ (weight[:, None] * by_tip)
    among = by_tip.T @ (weight[:, None] * by_tip)
    # links and tip, the other unknowns following them
    scale = 1 / np.sqrt(np.diag(N)[others])
    A = N[np.ix_(others, others)] * np.outer(scale, scale)
    B = np.hstack([N[np.ix_(others, links)], across[others]]) * scale[:, None]
    S = np.block([[N[np.ix_(links, links)], across[links]], [across[links].T, among]])
    S -= B.T @ np.linalg.solve(A, B)
    # at the minimum the data pull the links as hard as the size told holds them back
    pull = np.concatenate(
        [
            -start / scales.of_links(len(start) // 6) ** 2,
            by_tip.T @ (weight * contacts.residuals_mm),
        ]
    )
    return _weighed(S, pull, start, scales)


def _weighed(S: Floats, pull: Floats, start: Floats, scales: Scales) -> TipPlace:
    """The tip's place over all sizes of the links' errors, each by how likely it is.

    Args:
        S: (L + 3, L + 3) what the data tell of links and tip.
        pull: (L + 3,) the data's gradient where the links' errors are ``start`` (L,) and the
            tip is in its place.
    """
    count, beside = len(start), np.concatenate([start, np.zeros(3)])
    in_place, astray, off_mm, covariances = [], [], [], []
    for size in _sizes(scales):
        sd, prior = size.of_links(count // 6), size_prior(size)
        in_place.append(likely_links(S[:count, :count], pull[:count], start, sd)[0] + prior)
        for astray_mm in ASTRAY_MM:
            both = np.concatenate([sd, np.full(3, astray_mm)])
            log, step, covariance = likely_links(S, pull, beside, both)
            astray.append(log + prior - np.log(len(ASTRAY_MM)))
            off_mm.append(step[count:])
            covariances.append(covariance[count:, count:])
    weight = np.exp(np.array(astray) - max(astray))
    weight /= weight.sum()
    off, apart = weight @ np.array(off_mm), np.array(off_mm) - weight @ np.array(off_mm)
    covariance = np.einsum("s,sij->ij", weight, np.array(covariances))
    covariance += np.einsum("s,si,sj->ij", weight, apart, apart)
    evidence = 2 * float(np.logaddexp.reduce(astray) - np.logaddexp.reduce(in_place))
    return TipPlace(off, covariance, evidence)


def _sizes(scales: Scales) -> list[Scales]:
    return [
        replace(scales, links_rad=scales.links_rad * turn, links_mm=scales.links_mm * shift)
        for turn in FACTORS
        for shift in FACTORS
        if abs(np.log(turn / shift)) < TOGETHER
    ]
