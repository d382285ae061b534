import { sendVerify } from "../api/verifyCommands";
import type { VerifyView } from "../api/wire";
import { StepDots } from "../flow/StepDots";
import { Actions } from "../parts/Actions";
import { BigNumber } from "../parts/BigNumber";
import { CardHead } from "../parts/CardHead";
import { Findings } from "../parts/Findings";
import { newFindings } from "../parts/findings";
import { Busy, Progress } from "../parts/Progress";
import { useStepHeading } from "../parts/useStepHeading";
import { asSent } from "../state/localized";
import { Verdict } from "./BigVerdict";

/** What to do now: the server's words, number, progress and allowed acts. */
export function VerifyCard({ view }: { view: VerifyView }) {
  const { verdict } = view.picture;
  const heading = useStepHeading(view.step);
  return (
    <>
      <StepDots view={view} />
      <CardHead title={view.title} text={view.instruction} help={`verify/${view.step}`} ref={heading} />
      {verdict ? <Verdict {...verdict} /> : view.number && <BigNumber number={view.number} />}
      {view.progress && <Progress {...view.progress} />}
      {view.busy && <Busy key={view.busy.text} {...view.busy} />}
      <Actions
        actions={view.actions}
        busy={view.busy !== null}
        onAct={(action) => sendVerify(action.name, action.args)}
      >
        <Findings findings={newFindings(view.findings, view.actions, verdict ? [asSent(verdict).text] : [])} />
      </Actions>
    </>
  );
}
