"""The steps 'place', 'capture' and 'solve': the calibration picture. Pure."""

from collections.abc import Sequence

from app.guide.body import Body, lost_devices, offer
from app.guide.live import Live
from app.guide.state import CalibrationState, Capture
from app.guide.touching import sentence
from app.guide.view import CameraPicture, LiveNumber, StillPicture
from app.station.findings import Finding

FEWEST_CORNERS = 8


def place_step(state: CalibrationState, live: Live) -> Body:
    """Bring the sensor over the object and clamp the arm."""
    found = live.corners_seen >= FEWEST_CORNERS
    return Body(
        instruction=(
            "The object is in the picture. Hold the arm there, or clamp it."
            if found
            else "Hold the sensor over the object so that the whole of it is in the picture."
        ),
        picture=CameraPicture(),
        number=_stillness(live),
        findings=[*lost_devices(live), *_picture_findings(live)],
        actions=[offer(state, live, "confirm_place", "The object is in the picture", primary=True)],
    )


def capture_step(state: CalibrationState, live: Live) -> Body:
    """Take the picture while the arm is still."""
    picture = state.picture
    if picture is not None:
        return Body(
            instruction="A picture was taken already. Keep it, or take a new one.",
            picture=still_picture(state.session_id, picture, live),
            actions=[
                offer(state, live, "keep_picture", "Keep this picture", primary=True),
                offer(state, live, "retake", "Take a new picture"),
            ],
        )
    return Body(
        instruction="Hold still and take the picture. The laser switches itself.",
        picture=CameraPicture(),
        number=_stillness(live),
        findings=[*lost_devices(live), *_picture_findings(live)],
        actions=[offer(state, live, "capture", "Take the picture", primary=True)],
    )


def solve_step(state: CalibrationState, live: Live) -> Body:
    """Compute the calibration from the points and the picture."""
    picture = state.picture
    findings = list(live.seen.findings) if live.seen else []
    refused = state.refused if state.refused and state.refused.inputs == state.inputs else None
    if refused is not None:
        why = f": {refused.why}" if refused.why else ""
        remedy = refused.remedy or "Go back, and take the picture or the points again."
        findings.insert(0, Finding("bad", f"{refused.what.rstrip('.')}{why}.", remedy))
    unusable = refused is not None or any(finding.quality == "bad" for finding in findings)
    return Body(
        instruction=(
            "This could not be solved. What was taken is kept."
            if refused
            else "Compute the calibration from the points and the picture."
        ),
        picture=still_picture(state.session_id, picture, live) if picture else CameraPicture(),
        findings=findings,
        actions=[
            offer(state, live, "solve", "Calibrate", primary=not unusable),
            offer(state, live, "retake", "Take a new picture", primary=unusable),
            offer(state, live, "back", "Back to the points", {"to": "touch"}),
        ],
    )


def still_picture(session_id: str, picture: Capture, live: Live) -> StillPicture:
    """The captured picture with what was found in it so far."""
    seen = live.seen
    return StillPicture(
        image_url=image_url(session_id, picture),
        width_px=picture.width_px,
        height_px=picture.height_px,
        corners=seen.corners if seen else (),
        outline=seen.outline if seen else (),
        stripe=seen.stripe if seen else (),
    )


def image_url(session_id: str, picture: Capture) -> str:
    """The captured picture's address; the session makes it one that may be cached."""
    name = picture.ambient.rsplit("/", 1)[-1]
    return f"/api/flow/image/{name}?session={session_id}"


def _stillness(live: Live) -> LiveNumber:
    still = live.stillness
    moved_um = None if still.moved_um != still.moved_um else still.moved_um
    return LiveNumber(
        "Movement of the tip",
        moved_um,
        "µm",
        0,
        "good" if still.still else "attention",
        still.text,
    )


def _picture_findings(live: Live) -> list[Finding]:
    """What is to be said of the live picture, each thing once."""
    if live.corners_seen >= FEWEST_CORNERS:
        found = Finding("good", f"{live.corners_seen} corners of the object are found.")
        return [found, *_once(live.picture_findings)]
    if live.laser_on:
        return [
            Finding(
                "neutral",
                "The laser is on, and beside it the object may be too dark to be found.",
                "Switch it off to aim. For the picture it is switched by itself.",
            )
        ]
    return _once(live.picture_findings)


def _once(findings: Sequence[Finding]) -> list[Finding]:
    told = {
        sentence(finding.text): Finding(
            finding.quality, sentence(finding.text), sentence(finding.remedy)
        )
        for finding in findings
    }
    return list(told.values())
