import type { VerifyView } from "../../api/wire";
import { SessionCard } from "../../flow/SessionCard";
import { newFindings } from "../../parts/findings";
import { asSent } from "../../state/localized";
import { Verdict } from "../judgement/BigVerdict";

/** What to do in this step of a verification; in its result the verdict stands for the number. */
export function VerifyCard({ view }: { view: VerifyView }) {
  const { verdict } = view.picture;
  return (
    <SessionCard
      guide="verify"
      view={view}
      number={verdict ? <Verdict {...verdict} /> : undefined}
      findings={newFindings(view.findings, view.actions, verdict ? [asSent(verdict).text] : [])}
    />
  );
}
