import type { PartView } from "../api/wire";
import { signedLength } from "../controls/lengths";
import { t } from "../state/language";
import styles from "./TouchList.module.css";

/** The touches of the feature in hand, each with what it is off. */
export function TouchList({ view }: { view: PartView }) {
  if (view.touches.length === 0) return null;
  return (
    <ol className={styles.touches} aria-label={t("ui-part-touches-of", { feature: view.feature })}>
      <li className={styles.name}>{view.feature}</li>
      {view.touches.map(({ number, residual_um }) => (
        <li key={number} className={styles.touch}>
          <span className={styles.number}>{number}</span>
          {residual_um === null ? "–" : signedLength(residual_um, "µm", 0)}
        </li>
      ))}
    </ol>
  );
}
