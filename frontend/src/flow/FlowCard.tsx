import { useEffect, useRef } from "react";

import { sendFlow } from "../api/commands";
import type { Finding, FlowView, LiveNumber, Picture } from "../api/types";
import { Actions } from "../parts/Actions";
import { BigNumber } from "../parts/BigNumber";
import { CardHead } from "../parts/CardHead";
import { Findings } from "../parts/Findings";
import { Busy, Progress } from "../parts/Progress";
import { StepDots } from "./StepDots";
import { Verdict } from "./Verdict";

/** The verdict stands in its own place; the number does not repeat it. */
function withoutEcho(number: LiveNumber, picture: Picture): LiveNumber {
  const echo = picture.kind === "result" && number.note === picture.result.verdict_text;
  return echo ? { ...number, note: "" } : number;
}

/** A finding that only repeats the verdict, or why an act is not possible, is said there. */
function withoutEchoes({ findings, actions, picture }: FlowView): Finding[] {
  const told = new Set(actions.filter(({ enabled }) => !enabled).map(({ why_not }) => why_not));
  if (picture.kind === "result") told.add(picture.result.verdict_text);
  return findings.filter(({ text }) => !told.has(text));
}

/** What to do in this step: the server's words, number, progress and allowed acts. */
export function FlowCard({ view }: { view: FlowView }) {
  const heading = useRef<HTMLHeadingElement>(null);
  const shown = useRef(view.step);

  /* A new step takes the focus, so that Enter presses nothing and Tab leads to its first act. */
  useEffect(() => {
    if (shown.current === view.step) return;
    shown.current = view.step;
    heading.current?.focus({ preventScroll: true });
  }, [view.step]);

  return (
    <>
      <StepDots view={view} />
      <CardHead title={view.title} text={view.instruction} ref={heading} />
      {view.picture.kind === "result" && <Verdict result={view.picture.result} />}
      {view.number && <BigNumber number={withoutEcho(view.number, view.picture)} />}
      {view.progress && <Progress {...view.progress} />}
      {view.busy && <Busy key={view.busy.text} {...view.busy} />}
      <Actions actions={view.actions} onAct={(action) => sendFlow(action.name, action.args)}>
        <Findings findings={withoutEchoes(view)} />
      </Actions>
    </>
  );
}
