"""What the operator is asked to do in each step of an arm session. Pure."""

from crenel.guide.arm.rules import SEATS_WANTED, places_taken
from crenel.guide.arm.state import ArmState, SeatSamples
from crenel.messages.message import Text, message

WHERE = (
    message("near-base"),
    message("far-out"),
    message("left"),
    message("right"),
    message("high-up"),
    message("low-down"),
)
TIP_WORDS = {
    "seat": (
        message("clean-tip-clamp-sphere"),
        message("sphere-known-diameter-clamped-firmly-within"),
    ),
    "swing": (
        message("touch-sphere"),
        message("top-all-around-side-wrist-turned"),
    ),
    "result": (message("checked"), message("tips-diameter-how-well-touches-agree")),
}


def instruct(state: ArmState, seat: SeatSamples | None) -> tuple[Text, Text]:
    """The title, and what to do now in one sentence."""
    if state.purpose == "tip":
        return TIP_WORDS[state.step]
    if state.step == "swing":
        assert seat is not None
        if state.touching:
            return (
                message("touch-place", place=seat.place),
                message("touch-all-over-upper-half-every"),
            )
        return (
            message("swing-arm-about", place=seat.place),
            message("keep-tip-seat-swing-elbow-one"),
        )
    if state.step == "result":
        if state.purpose == "check":
            return message("checked"), message("what-tip-moved-while-held-one")
        if state.saved:
            return (
                message("use"),
                message("calibrate-sensors-again-their-place-belongs"),
            )
        return (
            message("before-after"),
            message("places-were-held-out-fit-over"),
        )
    if state.purpose == "check":
        return (
            message("put-tip-into-seat"),
            message("clamp-cone-ball-seat-about-two"),
        )
    done = len(state.seats)
    where = WHERE[done % len(WHERE)]
    if state.half_bar:
        return message("put-tip-into-bars-other-end"), message("leave-bar-where")
    if state.artefact.kind == "bar":
        return (
            message("put-tip-into-end-ball-bar"),
            message("clamp-bar-firmly-reach-put-tip", where=where),
        )
    if state.artefact.kind == "sphere":
        return message("clamp-sphere"), message("clamp-firmly-reach", where=where)
    if places_taken(state) >= SEATS_WANTED:
        return message("enough-places"), message("identify-arm-take-more-know-better")
    return (
        message("put-tip-into-seat-of-number", done=done + 1),
        message("clamp-seat-firmly-reach-put-tip", where=where),
    )
