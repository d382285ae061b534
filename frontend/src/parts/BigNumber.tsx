import type { LiveNumber } from "../api/types";
import { useSilence } from "../state/freshness";
import styles from "./BigNumber.module.css";
import { age, bound, figures } from "./format";
import { QualityMark } from "./QualityMark";

/** The one number the operator watches, readable from two metres; grey with its age when old. */
export function BigNumber({ number }: { number: LiveNumber }) {
  const { live, silent_s } = useSilence();
  const shown = number.value === null ? "–" : figures(number.value, number.decimals);
  return (
    <div className={styles.number} data-quality={number.quality} data-stale={!live || undefined}>
      <div className={styles.label}>
        {number.quality !== "neutral" && <QualityMark quality={number.quality} size="1.125rem" />}
        {bound(number.label)}
      </div>
      <div className={styles.value}>
        {shown}
        {number.value !== null && <span className={styles.unit}>{number.unit}</span>}
      </div>
      {(number.note || !live) && (
        <div className={styles.note}>{live ? bound(number.note) : `${age(silent_s)} old`}</div>
      )}
    </div>
  );
}
