"""Permissions of each route and each message. Anything not listed here is denied."""

from dataclasses import dataclass
from enum import Enum, auto

from crenel.messages.message import Text, message, word
from crenel.store.accounts import Role


class Right(Enum):
    """Required right, from the lowest to the highest."""

    enter = auto()
    """No right: the pages themselves, and the ways to sign in."""
    look = auto()
    """Signed in, or a kiosk."""
    scrape = auto()
    """A program with its own token, or anyone who may view."""
    be = auto()
    """Signed in as a person, with any role."""
    operate = auto()
    """An operator."""
    act = auto()
    """An operator who has control, or takes it because nobody has it."""
    administer = auto()
    """An administrator."""


ROLE = {
    Right.look: Role.viewer,
    Right.scrape: Role.viewer,
    Right.be: Role.viewer,
    Right.operate: Role.operator,
    Right.act: Role.operator,
    Right.administer: Role.admin,
}
"""The lowest role of each right that requires one."""


@dataclass(frozen=True, slots=True)
class Rule:
    """The right for a route, and the name of its action in the audit log; empty if it is not
    audited."""

    right: Right
    act: Text = ""


WEBSOCKET = "WEBSOCKET"
LOOK = Rule(Right.look)
ENTER = Rule(Right.enter)

ROUTES: dict[tuple[str, str], Rule] = {
    ("GET", "/{path:path}"): ENTER,
    ("HEAD", "/{path:path}"): ENTER,
    ("GET", "/api/session"): ENTER,
    ("GET", "/api/starting"): ENTER,
    ("POST", "/api/session"): ENTER,
    ("DELETE", "/api/session"): ENTER,
    ("POST", "/api/session/code"): ENTER,
    ("POST", "/api/session/admin"): ENTER,
    ("POST", "/api/session/kiosk"): ENTER,
    ("POST", "/api/session/provider"): ENTER,
    ("POST", "/api/session/provider/answer"): ENTER,
    ("POST", "/api/session/password"): Rule(Right.be, message("changed-own-password")),
    ("GET", "/api/openapi.json"): LOOK,
    (WEBSOCKET, "/api/live"): LOOK,
    ("GET", "/viewer"): LOOK,
    ("GET", "/viewer/{path:path}"): LOOK,
    (WEBSOCKET, "/viewer"): LOOK,
    (WEBSOCKET, "/viewer/"): LOOK,
    (WEBSOCKET, "/viewer/{key}"): LOOK,
    (WEBSOCKET, "/viewer/{key}/"): LOOK,
    ("GET", "/api/home"): LOOK,
    ("GET", "/api/calibrations"): LOOK,
    ("GET", "/api/calibrations/{calibration_id}/calibration.json"): LOOK,
    ("GET", "/api/calibrations/{calibration_id}"): LOOK,
    ("GET", "/api/calibrations/{calibration_id}/image/{name}"): LOOK,
    ("GET", "/api/calibration-history"): LOOK,
    ("GET", "/api/calibrations/{record_id}/report.{form}"): LOOK,
    ("GET", "/api/arm/{kind}/{record_id}/report.{form}"): LOOK,
    ("GET", "/api/verifications/{record_id}/report.{form}"): LOOK,
    ("GET", "/api/scans"): LOOK,
    ("GET", "/api/scans/{scan_id}"): LOOK,
    ("GET", "/api/scans/{scan_id}/cloud.{form}"): LOOK,
    ("GET", "/api/scans/{scan_id}/picture.png"): LOOK,
    ("GET", "/api/scans/{record_id}/report.{form}"): LOOK,
    ("GET", "/api/cloud-formats"): LOOK,
    ("GET", "/api/library"): LOOK,
    ("GET", "/api/part"): LOOK,
    ("POST", "/api/part"): Rule(Right.act, message("named-next-part")),
    ("POST", "/api/scans/{scan_id}/part"): Rule(Right.act, message("named-part")),
    ("POST", "/api/merged-scans"): Rule(Right.act, message("merged-scans")),
    ("POST", "/api/scans/{scan_id}/opened"): Rule(Right.act),
    ("POST", "/api/scans/{scan_id}/continued"): Rule(Right.act, message("continued-scan")),
    ("POST", "/api/scans/{scan_id}/comparison"): Rule(Right.act),
    ("DELETE", "/api/view/comparison"): Rule(Right.act),
    ("POST", "/api/view/replay"): Rule(Right.act),
    ("POST", "/api/scans/{scan_id}/name"): Rule(Right.act, message("renamed-scan")),
    ("POST", "/api/scans/{scan_id}/fetch"): Rule(Right.act, message("fetched-scan")),
    ("DELETE", "/api/scans/{scan_id}"): Rule(Right.act, message("deleted-scan")),
    ("POST", "/api/scans/{scan_id}/shown"): Rule(Right.act),
    ("GET", "/api/cad"): LOOK,
    ("POST", "/api/cad"): Rule(Right.act, message("added-compared-part")),
    ("PUT", "/api/cad/{part_id}/file"): Rule(Right.act),
    ("DELETE", "/api/cad/{part_id}"): Rule(Right.act, message("removed-compared-part")),
    ("GET", "/api/scans/{scan_id}/size"): LOOK,
    ("GET", "/api/scans/{scan_id}/deviation"): LOOK,
    ("GET", "/api/scans/{scan_id}/deviation.json"): LOOK,
    ("GET", "/api/scans/{scan_id}/map.ply"): LOOK,
    ("POST", "/api/scans/{scan_id}/deviation"): Rule(Right.act, message("compared-scan-with-part")),
    ("POST", "/api/comparison/cancel"): Rule(Right.act, message("cancelled-comparison")),
    ("DELETE", "/api/scans/{scan_id}/deviation"): Rule(
        Right.act, message("removed-comparison-of-scan")
    ),
    ("POST", "/api/scans/{scan_id}/deviation/shown"): Rule(Right.act),
    ("POST", "/api/scans/{scan_id}/deviation/place"): LOOK,
    ("GET", "/api/view"): LOOK,
    ("POST", "/api/view/viewpoint"): LOOK,
    ("POST", "/api/view/colours"): Rule(Right.act),
    ("POST", "/api/view/fits"): Rule(Right.act),
    ("POST", "/api/view/fits/{fit_id}/shape"): Rule(Right.act),
    ("DELETE", "/api/view/fits/last-change"): Rule(Right.act),
    ("DELETE", "/api/view/fits/{fit_id}"): Rule(Right.act),
    ("POST", "/api/view/relations"): Rule(Right.act),
    ("POST", "/api/view/cuts"): Rule(Right.act, message("cut-points-away")),
    ("DELETE", "/api/view/cuts/last"): Rule(Right.act, message("undid-a-cut")),
    ("POST", "/api/view/arm"): Rule(Right.act),
    ("POST", "/api/view/weak"): Rule(Right.act),
    ("GET", "/api/flow"): LOOK,
    ("GET", "/api/flow/image/{name}"): LOOK,
    ("GET", "/api/flow/picture/{number}.zip"): Rule(Right.operate, message("took-picture-bundle")),
    ("POST", "/api/flow/start"): Rule(Right.act, message("began-resumed-calibration")),
    ("POST", "/api/flow/command"): Rule(Right.act, word("calibration")),
    ("GET", "/api/arm"): LOOK,
    ("GET", "/api/arm/checks"): LOOK,
    ("GET", "/api/arm/tips"): LOOK,
    ("GET", "/api/arm/identifications"): LOOK,
    ("POST", "/api/arm/start"): Rule(Right.act, message("began-resumed-arm-check")),
    ("POST", "/api/arm/command"): Rule(Right.act, message("arm-check-within-sentence")),
    ("GET", "/api/parts"): LOOK,
    ("POST", "/api/parts/start"): Rule(Right.act, message("began-resumed-inspection")),
    ("POST", "/api/parts/command"): Rule(Right.act, word("inspection")),
    ("POST", "/api/parts/programs"): Rule(Right.act, message("added-inspection-program")),
    ("GET", "/api/parts/inspections"): LOOK,
    ("GET", "/api/parts/inspections/{inspection_id}"): LOOK,
    ("GET", "/api/parts/inspections/{inspection_id}/view"): LOOK,
    ("GET", "/api/parts/inspections/{inspection_id}/folder.zip"): LOOK,
    ("GET", "/api/performance"): LOOK,
    ("POST", "/api/performance/start"): Rule(Right.act, message("began-resumed-performance-test")),
    ("POST", "/api/performance/command"): Rule(Right.act, word("performance test")),
    ("POST", "/api/performance/certificate"): Rule(Right.act, message("added-gauge-certificate")),
    ("GET", "/api/performances"): LOOK,
    ("GET", "/api/performance-history"): LOOK,
    ("GET", "/api/performances/{performance_id}"): LOOK,
    ("GET", "/api/performances/{record_id}/report.{form}"): LOOK,
    ("GET", "/api/performances/{record_id}/export.{form}"): LOOK,
    ("GET", "/api/export-formats"): LOOK,
    ("GET", "/api/verify"): LOOK,
    ("POST", "/api/verify/start"): Rule(Right.act, message("began-resumed-verification")),
    ("POST", "/api/verify/command"): Rule(Right.act, word("verification")),
    ("GET", "/api/verifications"): LOOK,
    ("GET", "/api/verifications/{verification_id}"): LOOK,
    ("GET", "/api/verifications/{verification_id}/cloud/{number}/map"): LOOK,
    ("GET", "/api/verifications/{verification_id}/study"): LOOK,
    ("POST", "/api/verifications/{verification_id}/study"): Rule(
        Right.act, message("rebuilt-verification-every-calibration")
    ),
    ("POST", "/api/temperature"): Rule(Right.act, message("entered-the-temperature")),
    ("GET", "/api/scan"): LOOK,
    ("POST", "/api/scan/start"): Rule(Right.act, message("started-scan")),
    ("POST", "/api/scan/stop"): Rule(Right.act, message("stopped-scan")),
    ("POST", "/api/scan/simulation"): Rule(Right.act, message("moved-simulation-stopped")),
    ("POST", "/api/demonstration"): Rule(Right.act, message("began-demonstration")),
    ("POST", "/api/demonstration/stop"): Rule(Right.be, message("stopped-demonstration")),
    ("GET", "/api/activity"): LOOK,
    ("POST", "/api/activity/end"): Rule(Right.act, message("ended-activity")),
    ("POST", "/api/laser/on"): Rule(Right.act, message("switched-laser")),
    # everyone who sees a danger can stop it, whoever has control
    ("POST", "/api/laser/off"): Rule(Right.be, message("switched-laser-off")),
    ("POST", "/api/stop"): Rule(Right.be, message("pressed-stop")),
    ("POST", "/api/exposure"): Rule(Right.act),
    ("POST", "/api/sensor"): Rule(Right.act, message("selected-sensor")),
    ("GET", "/api/settings"): LOOK,
    ("POST", "/api/settings"): Rule(Right.act, message("changed-settings")),
    ("POST", "/api/settings/exposure"): Rule(Right.act, message("set-exposure-picture")),
    ("POST", "/api/settings/delay/find"): Rule(Right.act, message("looked-arms-delay")),
    ("POST", "/api/settings/delay/pass"): Rule(
        Right.act, message("had-simulation-pass-over-plate")
    ),
    ("POST", "/api/settings/delay"): Rule(Right.act, message("applied-dropped-arms-delay")),
    ("GET", "/api/settings/logo"): LOOK,
    ("POST", "/api/settings/logo"): Rule(Right.administer, message("changed-logo")),
    ("DELETE", "/api/settings/logo"): Rule(Right.administer, message("removed-logo")),
    ("GET", "/api/datasheets"): LOOK,
    ("GET", "/api/datasheets/joints"): LOOK,
    ("GET", "/api/datasheets/{kind}/{file}"): LOOK,
    ("POST", "/api/datasheets/check"): Rule(Right.operate),
    ("POST", "/api/datasheets/model"): Rule(Right.operate),
    ("POST", "/api/datasheets/block-certificate"): Rule(Right.operate),
    ("POST", "/api/datasheets/block-certificate/page"): Rule(Right.operate),
    ("POST", "/api/datasheets"): Rule(Right.act, message("added-a-datasheet")),
    ("POST", "/api/datasheets/retire"): Rule(Right.act, message("retired-a-datasheet")),
    ("POST", "/api/datasheets/restore"): Rule(Right.act, message("brought-a-datasheet-back")),
    ("POST", "/api/designs/block"): Rule(Right.operate),
    ("GET", "/api/designs/block/{design_id}/{file}"): Rule(Right.operate),
    ("GET", "/api/designs/board"): Rule(Right.operate),
    ("GET", "/api/designs/board/board.pdf"): Rule(Right.operate),
    # drivers open files, ports and addresses that their options name
    ("GET", "/api/devices"): Rule(Right.administer),
    ("POST", "/api/devices/search"): Rule(Right.administer),
    ("POST", "/api/devices"): Rule(Right.administer, message("chose-a-device")),
    ("POST", "/api/devices/remove"): Rule(Right.administer, message("took-a-device-out")),
    ("POST", "/api/devices/datasheet"): Rule(Right.administer, message("described-a-camera")),
    ("POST", "/api/devices/arm-datasheet"): Rule(Right.administer, message("described-an-arm")),
    ("POST", "/api/devices/trial"): Rule(Right.administer, message("tried-a-device")),
    ("GET", "/api/devices/trial"): Rule(Right.administer),
    ("GET", "/api/devices/trial/picture.jpg"): Rule(Right.administer),
    ("DELETE", "/api/devices/trial"): Rule(Right.administer),
    ("POST", "/api/control/ask"): Rule(Right.operate, message("asked-control")),
    ("POST", "/api/control/answer"): Rule(Right.operate, message("answered-who-asked-control")),
    ("POST", "/api/control/release"): Rule(Right.operate, message("let-go-control")),
    ("POST", "/api/control/take"): Rule(Right.operate, message("took-control-over")),
    ("GET", "/api/accounts"): Rule(Right.administer),
    ("POST", "/api/accounts"): Rule(Right.administer, message("added-account")),
    ("POST", "/api/account"): Rule(Right.administer, message("changed-account")),
    ("DELETE", "/api/account"): Rule(Right.administer, message("removed-account")),
    ("GET", "/api/kiosk-links"): Rule(Right.administer),
    ("POST", "/api/kiosk-links"): Rule(Right.administer, message("made-kiosk-link")),
    ("DELETE", "/api/kiosk-links/{link_id}"): Rule(Right.administer, message("removed-kiosk-link")),
    ("GET", "/api/audit"): Rule(Right.administer),
    ("GET", "/metrics"): Rule(Right.scrape),
    ("GET", "/api/health"): LOOK,
    ("GET", "/api/logs"): Rule(Right.operate),
    ("GET", "/api/support.zip"): Rule(Right.operate, message("took-support-bundle")),
    ("POST", "/api/backup"): Rule(Right.administer, message("began-backup")),
    ("GET", "/api/notifications"): Rule(Right.administer),
    ("POST", "/api/notifications"): Rule(Right.administer, message("changed-notifications")),
    ("POST", "/api/notifications/test"): Rule(Right.administer, message("tried-notifications")),
    ("GET", "/api/tokens"): Rule(Right.administer),
    ("POST", "/api/tokens"): Rule(Right.administer, message("made-token-metrics")),
    ("DELETE", "/api/tokens/{token_id}"): Rule(Right.administer, message("ended-token-metrics")),
} | {(method, "/api/{path:path}"): ENTER for method in ("GET", "POST", "PUT", "PATCH", "DELETE")}

MESSAGES: dict[str, Right] = {
    "preview": Right.look,
    "preview_ack": Right.look,
    "stations": Right.look,
    "beat": Right.look,
}
"""The right for each kind of message of a live connection."""


def has_right(right: Right, role: Role | None, kiosk: bool) -> bool:
    """Whether a visitor has a right, apart from control; ``role`` is None for nobody."""
    if right is Right.enter:
        return True
    if role is None or (kiosk and right not in (Right.look, Right.scrape)):
        return False
    return role >= ROLE[right]
