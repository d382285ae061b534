import type { ArticulationLine } from "../../api/wire";
import { PressButton } from "../../controls/PressButton";
import type { PlainId } from "../../messages/text";
import { t } from "../../state/language";
import styles from "./ArticulationList.module.css";

const STATES: Record<Exclude<ArticulationLine["state"], "done">, PlainId> = {
  todo: "ui-to-do",
  now: "ui-now",
  scanning: "ui-being-scanned",
  measuring: "ui-being-measured",
  refused: "ui-unusable",
};

interface ArticulationListProps {
  label: string;
  /** What is said of a line that is done. */
  done?: PlainId;
  lines: readonly Line[];
  /** Called to scan again what a line is of; without it, nothing is repeated. */
  onRepeat?: ((number: number) => void) | undefined;
}

interface Line extends ArticulationLine {
  /** Whether it can be scanned again; missing: once it is done. */
  repeatable?: boolean;
}

/** The five articulations of a step, the seven places, or the scans in one: what is done, and what each has shown. */
export function ArticulationList({ label, done = "ui-done", lines, onRepeat }: ArticulationListProps) {
  return (
    <ol className={styles.list} aria-label={label}>
      {lines.map(({ number, title, state, text, repeatable = state === "done" }, i) => (
        <li
          key={`${number} ${title}`}
          className={styles.row}
          data-state={state}
          data-before={i === 0 && lines.some((one) => one.number < number)}
        >
          <span className={styles.number}>{number}</span>
          <div className={styles.what}>
            <p className={styles.name}>
              {title} <span className={styles.state}>{t(state === "done" ? done : STATES[state])}</span>
            </p>
            {text && <p className={styles.detail}>{text}</p>}
          </div>
          {onRepeat && repeatable && (
            <PressButton kind="quiet" onPress={() => onRepeat(number)}>
              {t("ui-scan-again")}
            </PressButton>
          )}
        </li>
      ))}
    </ol>
  );
}
