import { type ReactNode, useId } from "react";

import type { Action } from "../api/types";
import { ActionButton } from "./ActionButton";
import styles from "./Actions.module.css";
import { bound } from "./format";

interface ActionsProps {
  actions: Action[];
  onAct: (action: Action) => Promise<void>;
  /** What belongs between the main act and the others. */
  children?: ReactNode;
}

/**
 * What may be done now. The main act stands where the eye is; the others keep to the foot of the
 * card, so that nothing that comes and goes moves them; disabled ones say why above them.
 */
export function Actions({ actions, onAct, children }: ActionsProps) {
  const id = useId();
  const primary = actions.filter((action) => action.primary);
  const others = actions.filter((action) => !action.primary);
  const told = new Set(primary.map((action) => action.why_not));
  const reasons = reasonsOf(others).filter(({ why }) => !told.has(why));
  const idOf = (why: string) => {
    const i = reasons.findIndex((reason) => reason.why === why);
    return i < 0 ? undefined : `${id}${i}`;
  };
  return (
    <>
      {primary.map((action) => (
        <div key={keyOf(action)} className={styles.primary}>
          <ActionButton action={action} onAct={onAct} />
        </div>
      ))}
      <div className={styles.middle}>{children}</div>
      <div className={styles.foot}>
        {reasons.map(({ why, labels }, i) => (
          <p key={why} id={`${id}${i}`} className={styles.why}>
            <strong>{labels.join(", ")}:</strong> {bound(why)}
          </p>
        ))}
        <div className={styles.others}>
          {others.map((action) => (
            <ActionButton key={keyOf(action)} action={action} onAct={onAct} describedBy={idOf(action.why_not)} />
          ))}
        </div>
      </div>
    </>
  );
}

function keyOf(action: Action): string {
  return action.name + JSON.stringify(action.args);
}

interface Reason {
  why: string;
  labels: string[];
}

/** Each reason once, with the acts that it holds back. */
function reasonsOf(actions: Action[]): Reason[] {
  const reasons = new Map<string, string[]>();
  for (const { enabled, why_not, label } of actions) {
    if (!enabled && why_not) reasons.set(why_not, [...(reasons.get(why_not) ?? []), label]);
  }
  return Array.from(reasons, ([why, labels]) => ({ why, labels }));
}
