import type { FigureLine } from "../api/wire";
import { quantity } from "../messages/text";
import { measured } from "../parts/lengths";
import { QualityMark } from "../parts/QualityMark";
import { t } from "../state/language";
import styles from "./FigureBars.module.css";
import { DECISIONS, QUALITY, worded } from "./verification";

/** Each figure with its uncertainty and its limit. */
export function FigureBars({ found }: { found: FigureLine[] }) {
  return (
    <ul className={styles.list}>
      {found.map((figure) => (
        <Bar key={figure.name} figure={figure} />
      ))}
    </ul>
  );
}

function Bar({ figure }: { figure: FigureLine }) {
  const { limit, expanded_uncertainty: U, unit } = figure;
  const size = Math.abs(figure.value);
  const end = 1.08 * Math.max(limit ?? 0, size + U, 1e-6);
  const at = (value: number) => `${(100 * Math.min(Math.max(value, 0), end)) / end}%`;
  return (
    <li className={styles.figure} data-decision={figure.decision}>
      <div className={styles.head}>
        <span className={styles.title}>{figure.title}</span>
        <span className={styles.value}>{worded(figure)}</span>
      </div>
      <div className={styles.track} aria-hidden="true">
        <span className={styles.bar} style={{ width: at(size) }} />
        {U > 0 && (
          <span
            className={styles.unsure}
            style={{ left: at(size - U), width: `calc(${at(size + U)} - ${at(size - U)})` }}
          />
        )}
        {limit !== null && <span className={styles.limit} style={{ left: at(limit) }} />}
      </div>
      <p className={styles.words}>
        {limit === null ? (
          <span>{t("ui-for-information-without-a-limit")}</span>
        ) : (
          <>
            <QualityMark quality={QUALITY[figure.decision]} size="1.125rem" />
            <strong>{t(DECISIONS[figure.decision])}</strong>
            <span>{t("ui-limit-value", { value: quantity(limit, unit) })}</span>
          </>
        )}
        {U > 0 && <span>U = {measured(U, unit, U < 10 ? 1 : 0)}, k = 2</span>}
      </p>
    </li>
  );
}
