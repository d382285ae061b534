import { useEffect, useRef } from "react";

import type { Finding } from "../api/types";
import { sendVerify } from "../api/verifyCommands";
import type { VerifyView } from "../api/verifyTypes";
import { Verdict } from "./BigVerdict";
import { StepDots } from "../flow/StepDots";
import { Actions } from "../parts/Actions";
import { BigNumber } from "../parts/BigNumber";
import { CardHead } from "../parts/CardHead";
import { Findings } from "../parts/Findings";
import { Busy, Progress } from "../parts/Progress";

/** A finding that only says why an act is not possible is said there. */
function withoutEchoes({ findings, actions, picture }: VerifyView): Finding[] {
  const told = new Set(actions.filter(({ enabled }) => !enabled).map(({ why_not }) => why_not));
  return findings.filter(({ text }) => !told.has(text) && text !== picture.verdict?.text);
}

/** What to do now: the server's words, number, progress and allowed acts. */
export function VerifyCard({ view }: { view: VerifyView }) {
  const heading = useRef<HTMLHeadingElement>(null);
  const shown = useRef(view.step);
  useEffect(() => {
    if (shown.current === view.step) return;
    shown.current = view.step;
    heading.current?.focus({ preventScroll: true });
  }, [view.step]);
  return (
    <>
      <StepDots view={view} />
      <CardHead title={view.title} text={view.instruction} help={`verify/${view.step}`} ref={heading} />
      {view.picture.verdict ? (
        <Verdict {...view.picture.verdict} />
      ) : (
        view.number && <BigNumber number={view.number} />
      )}
      {view.progress && <Progress {...view.progress} />}
      {view.busy && <Busy key={view.busy.text} {...view.busy} />}
      <Actions actions={view.actions} busy={view.busy !== null} onAct={(action) => sendVerify(action.name, action.args)}>
        <Findings findings={withoutEchoes(view)} />
      </Actions>
    </>
  );
}
