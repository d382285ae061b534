import { useEffect, useRef } from "react";

import { sendFlow } from "../api/commands";
import type { Devices } from "../api/deviceTypes";
import type { FlowView } from "../api/flowTypes";
import type { Finding } from "../api/types";
import { Actions } from "../parts/Actions";
import { BigNumber } from "../parts/BigNumber";
import { CardHead } from "../parts/CardHead";
import { Findings } from "../parts/Findings";
import { PressButton } from "../parts/PressButton";
import { Busy, Progress } from "../parts/Progress";
import { go } from "../state/router";
import { useLive } from "../state/store";
import { StepDots } from "./StepDots";

/**
 * A finding that only repeats the number's note, why an act is not possible or which device is
 * lost, is said there.
 */
function withoutEchoes({ findings, actions, number }: FlowView, lost: string): Finding[] {
  const told = new Set(actions.filter(({ enabled }) => !enabled).map(({ why_not }) => why_not));
  const said = number?.note ?? "";
  return findings.filter(({ text }) => !told.has(text) && !said.startsWith(text) && !(lost && text.startsWith(`${lost}: `)));
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
        onAct={(action) => sendFlow(action.name, action.args)}
      >
        <Findings findings={withoutEchoes(view, lost)} />
      </Actions>
    </>
  );
}
