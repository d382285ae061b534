import type { Validity } from "../api/homeTypes";
import rows from "../parts/List.module.css";
import { bound } from "../parts/format";
import { PressButton } from "../parts/PressButton";
import { QualityMark } from "../parts/QualityMark";
import { t, words } from "../state/language";
import { go } from "../state/router";
import styles from "./ValidityList.module.css";

const WORD: Record<Validity["state"], string> = {
  valid: words("valid"),
  due: words("due"),
  missing: words("to do"),
  failed: words("failed"),
  unsure: words("not decided"),
};

/** What must be in order to measure: whether it is, why not, and where it is done; what comes
 *  `next` has its button beside the list. */
export function ValidityList({ checks, next }: { checks: Validity[]; next: string }) {
  return (
    <ul className={rows.list} aria-label={t("What is valid and what is due")}>
      {checks.map((check) => (
        <li key={check.id} className={styles.row} data-state={check.state}>
          <QualityMark quality={check.quality} size="1.5rem" />
          <div className={styles.what}>
            <p className={styles.title}>
              {check.title}
              <span className={styles.state} data-quality={check.quality}>
                {t(WORD[check.state])}
              </span>
            </p>
            <p className={styles.text}>{bound(check.text)}</p>
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
