import type { LiveNumber } from "../api/wire";
import { useSilence } from "../state/freshness";
import { t } from "../state/language";
import styles from "./BigNumber.module.css";
import { age } from "./format";
import { lengthFigures, unitOf } from "./lengths";
import { QualityMark } from "./QualityMark";

interface BigNumberProps {
  number: LiveNumber;
  /** The number decides: it has the colour of its quality, with its reason below. */
  verdict?: boolean;
  /** From a record, not live: it does not age with the connection. */
  stored?: boolean;
}

/** The one number the operator watches, readable from two metres; grey with its age when old. */
export function BigNumber({ number, verdict = false, stored = false }: BigNumberProps) {
  const { live: heard, silent_s } = useSilence();
  const live = heard || stored;
  const text = number.value === null ? "–" : lengthFigures(number.value, number.unit, number.decimals);
  return (
    <div
      className={styles.number}
      data-quality={number.quality}
      data-stale={!live || undefined}
      data-verdict={verdict || undefined}
    >
      <div className={styles.label}>
        {number.quality !== "neutral" && (
          <QualityMark quality={number.quality} size={verdict ? "1.5rem" : "1.125rem"} />
        )}
        {number.label}
      </div>
      <div className={styles.value} data-none={number.value === null || undefined}>
        {text}
        {number.value !== null && <span className={styles.unit}>{unitOf(number.unit)}</span>}
      </div>
      {(number.note || !live) && (
        <div className={styles.note}>{live ? number.note : t("ui-old-age", { age: age(silent_s) })}</div>
      )}
    </div>
  );
}
