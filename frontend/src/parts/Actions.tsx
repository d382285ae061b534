import { Modal } from "@mantine/core";
import { useId, useState } from "react";

import type { Action } from "../api/types";
import styles from "./Actions.module.css";
import { PressButton } from "./PressButton";

interface ActionsProps {
  actions: Action[];
  onAct: (action: Action) => Promise<void>;
}

/** What may be done now: one primary act, the others below; a disabled one says why beside it. */
export function Actions({ actions, onAct }: ActionsProps) {
  const primary = actions.filter((action) => action.primary);
  const others = actions.filter((action) => !action.primary);
  return (
    <div className={styles.actions}>
      {primary.map((action) => (
        <ActionButton key={keyOf(action)} action={action} onAct={onAct} />
      ))}
      {others.length > 0 && (
        <div className={styles.others}>
          {others.map((action) => (
            <ActionButton key={keyOf(action)} action={action} onAct={onAct} />
          ))}
        </div>
      )}
    </div>
  );
}

function keyOf(action: Action): string {
  return action.name + JSON.stringify(action.args);
}

function ActionButton({ action, onAct }: { action: Action; onAct: (action: Action) => Promise<void> }) {
  const [asking, setAsking] = useState(false);
  const whyId = useId();
  const why = action.enabled ? "" : action.why_not;
  return (
    <div className={styles.action} data-primary={action.primary || undefined} data-why={why ? true : undefined}>
      <PressButton
        kind={action.primary ? "primary" : "secondary"}
        disabled={!action.enabled}
        describedBy={why ? whyId : undefined}
        onPress={() => (action.confirm ? setAsking(true) : onAct(action))}
      >
        {action.label}
      </PressButton>
      {why && (
        <p id={whyId} className={styles.why}>
          {why}
        </p>
      )}
      <Question action={action} opened={asking} onClose={() => setAsking(false)} onAct={onAct} />
    </div>
  );
}

interface QuestionProps {
  action: Action;
  opened: boolean;
  onClose: () => void;
  onAct: (action: Action) => Promise<void>;
}

/** Asked before the act, never after; the harmless answer has the focus. */
function Question({ action, opened, onClose, onAct }: QuestionProps) {
  const agree = async () => {
    onClose();
    await onAct(action);
  };
  return (
    <Modal opened={opened} onClose={onClose} title={action.label} centered radius="md" size="md">
      <p className={styles.question}>{action.confirm}</p>
      <div className={styles.answers}>
        <button type="button" className={styles.keep} data-autofocus onClick={onClose}>
          No, keep it
        </button>
        <PressButton onPress={agree}>{action.label}</PressButton>
      </div>
    </Modal>
  );
}
