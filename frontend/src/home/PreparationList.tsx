import type { PreparationStep } from "../api/wire";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import { t } from "../state/language";
import { go } from "../state/router";
import styles from "./ValidityList.module.css";

/** What the first calibration needs: what is there, and where the rest is brought about; the step
 *  `next` has its button beside the list. */
export function PreparationList({ steps, next }: { steps: PreparationStep[]; next: string }) {
  const needed = steps.filter(({ optional }) => !optional);
  const done = needed.filter((step) => step.done).length;
  return (
    <section className={styles.way} aria-labelledby="way">
      <h2 id="way" className={styles.heading}>
        {t("ui-way-to-the-first-calibration")}
        <span className={styles.state}>{t("ui-done-of-all", { done, all: needed.length })}</span>
      </h2>
      <ol className={rows.list}>
        {steps.map((step) => (
          <li key={step.id} className={styles.row} data-short>
            <QualityMark quality={step.quality} size="1.5rem" />
            <div className={styles.what}>
              <p className={styles.title}>
                {step.title}
                {step.optional && !step.done && <span className={styles.state}>{t("ui-recommended")}</span>}
              </p>
              <p className={styles.text}>{step.text}</p>
            </div>
            {!step.done && step.action !== next && (
              <PressButton free kind="quiet" onPress={() => go(step.page)}>
                {step.action}
              </PressButton>
            )}
          </li>
        ))}
      </ol>
    </section>
  );
}
