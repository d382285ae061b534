import { sendArm } from "../api/armCommands";
import type { ArmView } from "../api/wire";
import { StepDots } from "../flow/StepDots";
import { Actions } from "../parts/Actions";
import { BigNumber } from "../parts/BigNumber";
import { CardHead } from "../parts/CardHead";
import { Findings } from "../parts/Findings";
import { newFindings } from "../parts/findings";
import { Busy, Progress } from "../parts/Progress";
import { useStepHeading } from "../parts/useStepHeading";
import { ArmChoice } from "./ArmChoice";
import { ArtefactField } from "./ArtefactField";
import { LimitField } from "./LimitField";

/** A sphere is touched, a seat is swung in. */
function helpFor({ step, artefact }: ArmView): string {
  return step === "swing" && artefact.kind === "sphere" ? "arm/touch" : `arm/${step}`;
}

/** What to do now: the server's words, number, progress and allowed acts. */
export function ArmCard({ view }: { view: ArmView }) {
  const heading = useStepHeading(view.step);
  const choosing = view.step === "seat" && view.picture.seats.length === 0;
  return (
    <>
      <StepDots view={view} />
      <CardHead title={view.title} text={view.instruction} help={helpFor(view)} ref={heading} />
      {view.number && <BigNumber number={view.number} verdict={view.step === "result"} />}
      {view.progress && <Progress {...view.progress} />}
      {view.busy && <Busy key={view.busy.text} {...view.busy} />}
      <Actions actions={view.actions} busy={view.busy !== null} onAct={(action) => sendArm(action.name, action.args)}>
        {choosing && view.arms.length > 1 && <ArmChoice arms={view.arms} arm={view.arm} />}
        {view.step === "seat" && view.purpose !== "check" && (
          <ArtefactField artefact={view.artefact} disabled={view.busy !== null} only={view.purpose === "tip"} />
        )}
        {choosing && view.purpose !== "identify" && (
          <LimitField limit_um={view.picture.limit_um} tip={view.purpose === "tip"} />
        )}
        <Findings findings={newFindings(view.findings, view.actions)} />
      </Actions>
    </>
  );
}
