"""The one verification session of a station: its journal, its clouds, and what is shown of it."""

from pathlib import Path

import numpy as np

from crenel.errors import OperationError
from crenel.gauges.plan.document_gauge import (
    DEFAULT_LIMITS,
    GaugeFile,
    VerificationLimits,
    read_gauge,
)
from crenel.gauges.quick.document import CONTACTS
from crenel.gauges.quick.evaluate import (
    cloud_errors,
    gauge_figures,
    verification_verdict,
)
from crenel.gauges.quick.evaluate_gauge import GaugeFit
from crenel.gauges.quick.guide.flow import build_view
from crenel.gauges.quick.guide.rules import RULES, CloudResults, VerifyLive
from crenel.gauges.quick.guide.state import VerificationCloud, VerifyState, apply_row
from crenel.gauges.quick.guide.view import VerifyView
from crenel.gauges.quick.maths.probed_gauge import ProbedGauge, fit_probed_plane, fit_probed_sphere
from crenel.gauges.session.acts import is_recording
from crenel.gauges.session.gauge_session import GaugeServices, GaugeSession, Memo
from crenel.gauges.session.off_gauge import refuse_off_plane, refuse_off_sphere
from crenel.guide.common.datasheet_library import read_gauges
from crenel.guide.common.flow import Flow
from crenel.guide.common.guided_session import (
    NO_PROVENANCE,
    Provenance,
    new_session_id,
)
from crenel.guide.common.journal import Calibrations, Journal
from crenel.messages.message import message, quantity
from crenel.metrology.arm.kinematics import AnyArm, tip_centres, tip_of
from crenel.metrology.decision import GUARDED_95, DecisionRule
from crenel.metrology.transforms import Floats
from crenel.store.session_records import VerificationStore

KIND = "verify"
FLOW = Flow(KIND, "verify", VerifyState(), apply_row, build_view, RULES)
SAME_PLACE_MM = 0.3


class VerifyGuide(GaugeSession[VerifyState, VerifyLive, VerifyView, GaugeFile]):
    """The latest verification."""

    def __init__(
        self,
        station: GaugeServices,
        journal: Journal,
        calibrations: Calibrations,
        verifications: VerificationStore,
        data_folder: Path,
        limits: VerificationLimits = DEFAULT_LIMITS,
        signing: Provenance = NO_PROVENANCE,
        rule: DecisionRule = GUARDED_95,
    ) -> None:
        super().__init__(
            station,
            journal,
            FLOW,
            calibrations,
            data_folder,
            signing,
            rule,
            read_gauges,
            read_gauge,
        )
        self.verifications = verifications
        self._limits = limits
        self._judged = Memo[tuple[ProbedGauge | OperationError | None, CloudResults]]()
        self.resume()

    @property
    def folder(self) -> Path:
        """The present session's folder."""
        return self.data_folder / "verifications" / self.state.session_id

    # -- what is shown -------------------------------------------------------

    def live(self) -> VerifyLive:
        """The station as the session sees it."""
        state = self.state
        gauges, (gauge, arm) = self.gauges(), self.datasheets()
        touched, judged = self._results(gauge, arm)
        scans, scanning = state.step == "scan", state.open_cloud is not None
        return VerifyLive(
            gauges=gauges,
            gauge=gauge,
            limits=self.limits(gauge),
            touched=touched,
            judged=judged,
            rule=self.rule,
            **self.live_fields(arm, scans, scanning),
        )

    def limits(self, gauge: GaugeFile | None) -> VerificationLimits:
        """The gauge's own, and the station's where its certificate says nothing."""
        return gauge.limits.with_defaults(self._limits) if gauge is not None else self._limits

    def _results(
        self, gauge: GaugeFile | None, arm: AnyArm | None
    ) -> tuple[ProbedGauge | OperationError | None, CloudResults]:
        """What touches and clouds show; worked out once for each state."""

        def judge() -> tuple[ProbedGauge | OperationError | None, CloudResults]:
            touched = self._fit_touches(gauge, arm)
            return touched, self._judge(gauge, touched)

        return self._judged.get(self.state, judge)

    def _fit_touches(
        self, gauge: GaugeFile | None, arm: AnyArm | None
    ) -> ProbedGauge | OperationError | None:
        readings = np.array([touch.reading for touch in self.state.counted])
        if gauge is None or arm is None or not len(readings):
            return None
        try:
            if gauge.shape == "plane":
                return fit_probed_plane(arm, readings)
            assert gauge.radius_mm is not None
            return fit_probed_sphere(arm, readings, gauge.radius_mm)
        except OperationError as refusal:
            return refusal

    def _judge(
        self, gauge: GaugeFile | None, touched: ProbedGauge | OperationError | None
    ) -> CloudResults:
        if gauge is None:
            return CloudResults({}, {}, (), None)
        state = self.state
        probe = None if isinstance(touched, OperationError) or not state.by_probe else touched
        fits = {c.number: GaugeFit.model_validate(c.fit) for c in state.listed if c.fit is not None}
        errors = {number: cloud_errors(fit, gauge, probe) for number, fit in fits.items()}
        good = [fits[cloud.number] for cloud in state.good]
        figures = gauge_figures(good, gauge, probe, self.limits(gauge), self.rule)
        verdict = verification_verdict(figures, probe is not None) if figures else None
        return CloudResults(fits, errors, figures, verdict)

    # -- sessions ------------------------------------------------------------

    def begin(self, key: str | None) -> None:
        """A new session of the calibration in use, with the gauge of the last."""
        payload = self.first_payload(message("there-nothing-verify"), self.gauges().known)
        self.begin_session(VerifyState(session_id=new_session_id()), payload, key)

    # -- touches -------------------------------------------------------------

    def touch(self, until_ns: int | None, key: str | None) -> None:
        arm, mean = self.average_touch(until_ns)
        counted = self.state.counted
        if counted:
            tips = tip_centres(arm, np.array([*(t.reading for t in counted), mean.reading]))
            apart = np.linalg.norm(tips[:-1] - tips[-1], axis=1)
            if apart.min() < SAME_PLACE_MM:
                number = int(np.argmin(apart)) + 1
                raise OperationError(
                    "same-place",
                    message("place-touch", number=number),
                    message("away", min=quantity(1000.0 * apart.min(), "µm")),
                    message("touch-elsewhere"),
                )
            self._refuse_off_gauge(arm, tips[:-1], tips[-1])
        self.append("touched", {"reading": mean.reading.tolist()}, key)
        self.station.bus.event(
            "point_taken", message("contact-point-on-gauge", counted=len(self.state.counted))
        )
        self.keep_touches()

    def _refuse_off_gauge(self, arm: AnyArm, before_mm: Floats, tip_mm: Floats) -> None:
        gauge, _ = self.datasheets()
        if gauge is None:
            return
        if gauge.shape == "plane":
            refuse_off_plane(before_mm, tip_mm)
            return
        assert gauge.radius_mm is not None
        refuse_off_sphere(before_mm, tip_mm, gauge.radius_mm + tip_of(arm).diameter_mm / 2)

    def keep_touches(self) -> None:
        counted = self.state.counted
        self.write_touches(CONTACTS, ("gauge",) * len(counted), counted)

    def to_measure(self) -> VerificationCloud | None:
        """A cloud that is scanned and waits to be measured. One whose scan ended without the
        operator's word is ended here."""
        with self.lock:
            if not self.running:
                return None
            cloud = self.state.open_cloud
            if cloud is not None and not is_recording(self, cloud.name):
                self.append("cloud_ended", {"number": cloud.number, "ended": True})
            return next((cloud for cloud in self.state.clouds if cloud.waiting), None)
