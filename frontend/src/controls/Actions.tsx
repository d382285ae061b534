import { type ReactNode, useId } from "react";

import type { Action } from "../api/wire";
import { ActionButton } from "./ActionButton";
import styles from "./Actions.module.css";

interface ActionsProps {
  actions: Action[];
  /** A running job is shown: actions that wait for it need no separate reason. */
  busy?: boolean;
  onAct: (action: Action) => Promise<void>;
  /** Content between the main action and the others. */
  children?: ReactNode;
}

/**
 * The available actions. The main action is in view; the others stay at the bottom of the
 * card, so that changing content does not move them. Actions that give something up come last and
 * are less prominent; disabled actions have the reason above them.
 */
export function Actions({ actions, onAct, busy = false, children }: ActionsProps) {
  const id = useId();
  const primary = mainOnes(actions);
  const others = actions.filter((action) => !action.primary && !action.confirm);
  const leaving = actions.filter((action) => !action.primary && action.confirm);
  const primaryReasons = new Set(primary.map((action) => action.why_not));
  const reasons = busy ? [] : reasonsOf([...others, ...leaving]).filter(({ why }) => !primaryReasons.has(why));
  const idOf = (why: string) => {
    const i = reasons.findIndex((reason) => reason.why === why);
    return i < 0 ? undefined : `${id}${i}`;
  };
  return (
    <>
      {primary.map((action) => (
        <MainAct key={keyOf(action)}>
          <ActionButton action={action} onAct={onAct} />
        </MainAct>
      ))}
      <div className={styles.middle}>{children}</div>
      <div className={styles.foot} data-busy={busy || undefined}>
        {reasons.map(({ why, labels }, i) => (
          <p key={why} id={`${id}${i}`} className={styles.why}>
            <strong>{labels.join(", ")}:</strong> {why}
          </p>
        ))}
        {[others, leaving].map(
          (row, i) =>
            row.length > 0 && (
              <div key={i} className={styles.others}>
                {row.map((action) => (
                  <ActionButton key={keyOf(action)} action={action} onAct={onAct} describedBy={idOf(action.why_not)} />
                ))}
              </div>
            ),
        )}
      </div>
    </>
  );
}

/** Position of the main action: under the thumb on a phone, however long the card. */
export function MainAct({ children }: { children: ReactNode }) {
  return <div className={styles.primary}>{children}</div>;
}

/** The main actions; an unavailable one is omitted next to an available one. */
function mainOnes(actions: Action[]): Action[] {
  const primary = actions.filter((action) => action.primary);
  const possible = primary.filter((action) => action.enabled);
  return possible.length > 0 ? possible : primary;
}

function keyOf(action: Action): string {
  return action.name + JSON.stringify(action.args);
}

interface Reason {
  why: string;
  labels: string[];
}

/** Each reason once, with the actions that it prevents. */
function reasonsOf(actions: Action[]): Reason[] {
  const reasons = new Map<string, string[]>();
  for (const { enabled, why_not, label } of actions) {
    if (!enabled && why_not) reasons.set(why_not, [...(reasons.get(why_not) ?? []), label]);
  }
  return Array.from(reasons, ([why, labels]) => ({ why, labels }));
}
