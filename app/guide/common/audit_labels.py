"""The commands of the guided flows in the audit log."""

from app.messages.message import Text, message

AUDIT_LABELS = {
    "choose": message("chose-what-use"),
    "choose_arm": message("chose-arm"),
    "choose_artefact": message("chose-artefact"),
    "choose_gauge": message("chose-gauge"),
    "confirm_gauge": message("confirmed-gauge"),
    "confirm_devices": message("confirmed-devices"),
    "confirm_setup": message("confirmed-what-use"),
    "confirm_place": message("confirmed-object-picture"),
    "set_limit": message("set-limit"),
    "select_face": message("chose-face"),
    "take_point": message("took-point"),
    "touch": message("took-point"),
    "undo": message("took-last-one-back"),
    "redo": message("put-last-one-back"),
    "void_point": message("removed-point"),
    "void_touch": message("removed-point"),
    "confirm_touch": message("confirmed-touches"),
    "skip_touch": message("went-without-probe"),
    "capture": message("took-picture"),
    "retake": message("took-picture-again"),
    "keep_picture": message("kept-picture"),
    "another_pose": message("went-another-pose"),
    "void_pose": message("set-pose-aside"),
    "restore_pose": message("took-pose-back"),
    "begin": message("began-seat"),
    "finish": message("finished-seat"),
    "drop_swing": message("dropped-swing"),
    "drop_seat": message("dropped-seat"),
    "begin_cloud": message("began-cloud"),
    "finish_cloud": message("finished-cloud"),
    "drop_cloud": message("dropped-cloud"),
    "void_cloud": message("set-cloud-aside"),
    "restore_cloud": message("took-cloud-back"),
    "confirm_clouds": message("went-result"),
    "more_clouds": message("went-more-clouds"),
    "solve": message("had-calculated"),
    "fit": message("had-calculated"),
    "save": message("saved-result"),
    "restore": message("put-back-what-there-before"),
    "accept": message("accepted-result"),
    "back": message("went-step-back"),
    "reopen": message("went-back-points"),
    "repeat": message("began-again"),
    "again": message("began-again"),
    "run_simulation": message("started-simulation"),
    "stop_simulation": message("stopped-simulation"),
    "end": message("ended"),
    "abandon": message("abandoned"),
}


def audit_label(command: str) -> Text:
    """The command in words; one that no flow has as it was sent."""
    return AUDIT_LABELS.get(command, command)
