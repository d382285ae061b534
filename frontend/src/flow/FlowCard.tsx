import { sendFlow } from "../api/commands";
import type { Devices, FlowView } from "../api/wire";
import { mentions, type Text } from "../messages/text";
import { Actions } from "../parts/Actions";
import { BigNumber } from "../parts/BigNumber";
import { CardHead } from "../parts/CardHead";
import { Findings } from "../parts/Findings";
import { newFindings } from "../parts/findings";
import { PressButton } from "../parts/PressButton";
import { Busy, Progress } from "../parts/Progress";
import { useStepHeading } from "../parts/useStepHeading";
import { asSent } from "../state/localized";
import { go } from "../state/router";
import { useLive } from "../state/store";
import { StepDots } from "./StepDots";

/** The reason why a device is lost, which the banners display. */
function lostReasons(devices: Devices | null): Text[] {
  const lost = devices ? [devices.arm, devices.sensor].filter(({ state }) => state === "lost") : [];
  return lost.map((device) => asSent(device).text);
}

/** What to do in this step: the server's words, number, progress and allowed acts. */
export function FlowCard({ view }: { view: FlowView }) {
  const devices = useLive((s) => s.devices);
  /* A calibration that is over leads on to what comes next. */
  const next = useLive((s) => (!view.running && s.home?.next.page !== "calibrate" ? s.home?.next : undefined));
  const note = view.number ? [asSent(view.number).note] : [];
  const findings = newFindings(view.findings, view.actions, note).filter(
    (finding) => !lostReasons(devices).some((reason) => mentions(asSent(finding).text, reason)),
  );
  const heading = useStepHeading(view.step);
  return (
    <>
      <StepDots view={view} />
      <CardHead title={view.title} text={view.instruction} help={`flow/${view.step}`} ref={heading} />
      {view.number && <BigNumber number={view.number} verdict={view.picture.kind === "result"} />}
      {view.progress && <Progress {...view.progress} />}
      {view.busy && <Busy key={view.busy.text} {...view.busy} />}
      {next && (
        <PressButton free kind="primary" onPress={() => go(next.page)}>
          {next.label}
        </PressButton>
      )}
      <Actions
        actions={next ? view.actions.map((action) => ({ ...action, primary: false })) : view.actions}
        busy={view.busy !== null}
        whole={view.picture.kind === "still"}
        onAct={(action) => sendFlow(action.name, action.args)}
      >
        <Findings findings={findings} />
      </Actions>
    </>
  );
}
