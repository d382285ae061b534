import { type ReactNode, useId } from "react";

import type { Action } from "../api/wire";
import { ActionButton } from "./ActionButton";
import styles from "./Actions.module.css";

interface ActionsProps {
  actions: Action[];
  /** A running job is displayed: what waits for it needs no reason of its own. */
  busy?: boolean;
  /** What belongs between stays as it is, and is read whole: it does not come and go by itself. */
  whole?: boolean;
  onAct: (action: Action) => Promise<void>;
  /** What belongs between the main act and the others. */
  children?: ReactNode;
}

/**
 * What may be done now. The main act stands where the eye is; the others keep to the foot of the
 * card, so that nothing that comes and goes moves them, those that give something up last and
 * quietly; disabled ones have the reason above them.
 */
export function Actions({ actions, onAct, busy = false, whole = false, children }: ActionsProps) {
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
      <div className={styles.middle} data-whole={whole || undefined}>
        {children}
      </div>
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

/** The main act's place: under the thumb on a phone, however long the card. */
export function MainAct({ children }: { children: ReactNode }) {
  return <div className={styles.primary}>{children}</div>;
}

/** The main acts; next to one that can be done, one that cannot is left out. */
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

/** Each reason once, with the acts that it prevents. */
function reasonsOf(actions: Action[]): Reason[] {
  const reasons = new Map<string, string[]>();
  for (const { enabled, why_not, label } of actions) {
    if (!enabled && why_not) reasons.set(why_not, [...(reasons.get(why_not) ?? []), label]);
  }
  return Array.from(reasons, ([why, labels]) => ({ why, labels }));
}
