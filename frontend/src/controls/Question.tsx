import { Modal } from "@mantine/core";

import type { Action } from "../api/wire";
import { t } from "../state/language";
import { PressButton } from "./PressButton";
import styles from "./Question.module.css";

interface QuestionProps {
  action: Action;
  opened: boolean;
  onClose: () => void;
  onAct: (action: Action) => Promise<void>;
  /** The label of the harmless answer. */
  no?: string;
  /** As for PressButton. */
  free?: boolean;
}

/** A question before an action; the harmless answer has the focus. */
export function Question({ action, opened, onClose, onAct, no = t("ui-no-continue"), free = false }: QuestionProps) {
  const agree = async () => {
    const acted = onAct(action); // before the close, which is the other answer
    onClose();
    await acted;
  };
  return (
    <Modal
      opened={opened}
      onClose={onClose}
      withCloseButton={false}
      centered
      radius="md"
      size="md"
      attributes={{ content: { "aria-label": action.label } }}
    >
      <p className={styles.question}>{action.confirm}</p>
      <div className={styles.answers}>
        <button type="button" className={styles.no} data-autofocus onClick={onClose}>
          {no}
        </button>
        <PressButton free={free} onPress={agree}>
          {action.label}
        </PressButton>
      </div>
    </Modal>
  );
}
