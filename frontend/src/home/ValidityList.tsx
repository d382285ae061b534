import type { Validity } from "../api/wire";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";
import { go } from "../state/router";
import styles from "./ValidityList.module.css";

const STATES: Record<Validity["state"], PlainId> = {
  valid: "ui-valid",
  due: "ui-due",
  missing: "ui-to-do",
  failed: "ui-failed-lowercase",
  unsure: "ui-undecided",
};

/** What must be valid for measuring: its state, the reason, and where to fix it; the item
 *  `next` has its button beside the list. */
export function ValidityList({ checks, next }: { checks: Validity[]; next: string }) {
  return (
    <ul className={rows.list} aria-label={t("ui-validity")}>
      {checks.map((check) => (
        <li key={check.id} className={styles.row} data-state={check.state}>
          <QualityMark quality={check.quality} size="1.5rem" />
          <div className={styles.what}>
            <p className={styles.title}>
              {check.title}
              <span className={styles.state} data-quality={check.quality}>
                {t(STATES[check.state])}
              </span>
            </p>
            <p className={styles.text}>{check.text}</p>
          </div>
          {check.action !== next && (
            <PressButton free kind="quiet" onPress={() => go(check.page)}>
              {check.action}
            </PressButton>
          )}
        </li>
      ))}
    </ul>
  );
}
