import { t } from "../state/language";
import type { SessionView } from "../state/store";
import styles from "./StepDots.module.css";

/** The current step in one line, for screens too narrow for the list of steps. */
export function StepDots({ view }: { view: SessionView }) {
  const index = view.steps.findIndex((step) => step.id === view.step);
  return (
    <div className={styles.steps}>
      <span className={styles.words}>{t("ui-step-of", { n: index + 1, all: view.steps.length })}</span>
      {view.steps.map((step) => (
        <span
          key={step.id}
          className={styles.dot}
          data-state={step.state}
          data-here={step.id === view.step || undefined}
        />
      ))}
    </div>
  );
}
