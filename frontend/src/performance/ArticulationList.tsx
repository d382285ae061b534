import { sendCommand } from "../api/guideCommands";
import type { ArticulationLine } from "../api/wire";
import type { PlainId } from "../messages/text";
import { PressButton } from "../parts/PressButton";
import { t } from "../state/language";
import styles from "./ArticulationList.module.css";

const STATES: Record<ArticulationLine["state"], PlainId> = {
  todo: "ui-to-do",
  now: "ui-now",
  scanning: "ui-being-scanned",
  measuring: "ui-being-measured",
  done: "ui-done",
  refused: "ui-unusable",
};

interface ArticulationListProps {
  label: string;
  lines: ArticulationLine[];
  repeatable?: boolean;
}

/** The five articulations of a step, or the seven places: what is done, and what each has shown. */
export function ArticulationList({ label, lines, repeatable = false }: ArticulationListProps) {
  return (
    <ol className={styles.list} aria-label={label}>
      {lines.map(({ number, title, state, text }) => (
        <li key={number} className={styles.row} data-state={state}>
          <span className={styles.number}>{number}</span>
          <div className={styles.what}>
            <p className={styles.name}>
              {title} <span className={styles.state}>{t(STATES[state])}</span>
            </p>
            {text && <p className={styles.detail}>{text}</p>}
          </div>
          {repeatable && state === "done" && (
            <PressButton
              kind="quiet"
              onPress={() => sendCommand("performance", "begin_scan", { articulation: number })}
            >
              {t("ui-scan-again")}
            </PressButton>
          )}
        </li>
      ))}
    </ol>
  );
}
