import { sendFlow } from "../api/commands";
import type { Devices } from "../api/deviceTypes";
import type { FlowView } from "../api/flowTypes";
import { Actions } from "../parts/Actions";
import { BigNumber } from "../parts/BigNumber";
import { CardHead } from "../parts/CardHead";
import { Findings } from "../parts/Findings";
import { PressButton } from "../parts/PressButton";
import { Busy, Progress } from "../parts/Progress";
import { useStepHeading } from "../parts/useStepHeading";
import { withoutEchoes } from "../parts/withoutEchoes";
import { go } from "../state/router";
import { useLive } from "../state/store";
import { StepDots } from "./StepDots";

/** What the number's note says, or the picture of a device that is lost. */
function isSaid(text: string, { number }: FlowView, lost: string): boolean {
  return (number?.note ?? "").startsWith(text) || (lost !== "" && text.startsWith(`${lost}: `));
}

/** The station names one lost device at a time, the arm before the sensor. */
function lostTitle(devices: Devices | null): string {
  const lost = devices && [devices.arm, devices.sensor].find(({ state }) => state === "lost");
  return lost ? lost.title : "";
}

/** What to do in this step: the server's words, number, progress and allowed acts. */
export function FlowCard({ view }: { view: FlowView }) {
  const lost = useLive((s) => lostTitle(s.devices));
  /* A calibration that is over leads on to what comes next. */
  const next = useLive((s) => (!view.running && s.home?.next.page !== "calibrate" ? s.home?.next : undefined));
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
        <Findings findings={withoutEchoes(view.findings, view.actions, (text) => isSaid(text, view, lost))} />
      </Actions>
    </>
  );
}
