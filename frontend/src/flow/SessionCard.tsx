import type { ReactNode } from "react";

import { sendCommand } from "../api/guideCommands";
import type { Action, Finding } from "../api/wire";
import { Actions } from "../controls/Actions";
import { BigNumber } from "../controls/BigNumber";
import { CardHead } from "../controls/CardHead";
import { Findings } from "../controls/Findings";
import { Busy, Progress } from "../controls/Progress";
import { useStepHeading } from "../controls/useStepHeading";
import type { Guide, SessionView } from "../state/store";
import { StepDots } from "./StepDots";

interface SessionCardProps {
  guide: Guide;
  view: SessionView;
  findings: Finding[];
  actions?: Action[];
  /** Which help belongs to the step, where it is not that of its name. */
  help?: string;
  /** The number decides. */
  verdict?: boolean;
  /** In the place of the number. */
  number?: ReactNode;
  /** What leads on from a session that is over. */
  next?: ReactNode;
  /** What belongs between the main act and the findings. */
  children?: ReactNode;
}

/** What to do now in a guided session: the server's words, number, progress and allowed acts. */
export function SessionCard({
  guide,
  view,
  findings,
  actions = view.actions,
  help = view.step,
  verdict = false,
  number,
  next,
  children,
}: SessionCardProps) {
  const heading = useStepHeading(view.step);
  return (
    <>
      <StepDots view={view} />
      <CardHead title={view.title} text={view.instruction} help={`${guide}/${help}`} ref={heading} />
      {number ?? (view.number && <BigNumber number={view.number} verdict={verdict} />)}
      {view.progress && <Progress {...view.progress} />}
      {view.busy && <Busy key={view.busy.text} {...view.busy} />}
      {next}
      <Actions
        actions={actions}
        busy={view.busy !== null}
        onAct={(action) => sendCommand(guide, action.name, action.args)}
      >
        {children}
        <Findings findings={findings} />
      </Actions>
    </>
  );
}
