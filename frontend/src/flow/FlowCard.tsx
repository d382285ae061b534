import type { Devices, FlowView } from "../api/wire";
import { MainAct } from "../controls/Actions";
import { newFindings } from "../controls/findings";
import { PressButton } from "../controls/PressButton";
import { mentions, type Text } from "../messages/text";
import { t } from "../state/language";
import { asSent } from "../state/localized";
import { go } from "../state/router";
import { useLive } from "../state/store";
import { SessionCard } from "./SessionCard";

/** The reason why a device is lost, which the banners display. */
function lostReasons(devices: Devices | null): Text[] {
  const lost = devices ? [devices.arm, devices.sensor].filter(({ state }) => state === "lost") : [];
  return lost.map((device) => asSent(device).text);
}

/** What to do in this step of a calibration. */
export function FlowCard({ view }: { view: FlowView }) {
  const devices = useLive((s) => s.devices);
  /* A calibration that is over leads on to what comes next. */
  const next = useLive((s) => (!view.running && s.home?.next.page !== "calibrate" ? s.home?.next : undefined));
  const canScan = useLive((s) => s.scan?.state === "idle");
  const note = view.number ? [asSent(view.number).note] : [];
  const findings = newFindings(view.findings, view.actions, note).filter(
    (finding) => !lostReasons(devices).some((reason) => mentions(asSent(finding).text, reason)),
  );
  return (
    <SessionCard
      guide="flow"
      view={view}
      findings={findings}
      actions={next ? view.actions.map((action) => ({ ...action, primary: false })) : view.actions}
      verdict={view.picture.kind === "result"}
      next={
        next && (
          <>
            <MainAct>
              <PressButton free kind="primary" onPress={() => go(next.page)}>
                {next.label}
              </PressButton>
            </MainAct>
            {canScan && next.page !== "scan" && (
              <PressButton free onPress={() => go("scan")}>
                {t("ui-scan-with-it")}
              </PressButton>
            )}
          </>
        )
      }
    />
  );
}
