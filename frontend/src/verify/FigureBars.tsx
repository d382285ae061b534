import type { FigureLine } from "../api/wire";
import { quantity } from "../messages/text";
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

/** An uncertainty, k = 2; `by` is empty of records that do not tell the two apart. */
interface Uncertainty {
  by: "test" | "measurement" | "";
  value: number;
}

/** The one that the limit is judged by, and the other. */
function uncertainties(figure: FigureLine): [Uncertainty, Uncertainty | null] {
  const { expanded_uncertainty, test_uncertainty } = figure;
  if (test_uncertainty === null) return [{ by: "", value: expanded_uncertainty }, null];
  const measurement: Uncertainty = { by: "measurement", value: expanded_uncertainty };
  const test: Uncertainty = { by: "test", value: 2 * test_uncertainty };
  return figure.judged_by === "test" ? [test, measurement] : [measurement, test];
}

function stated({ by, value }: Uncertainty, unit: FigureLine["unit"]): string {
  return t("ui-u-value", { by, value: quantity(value, unit, value < 10 ? 1 : 0) });
}

function Bar({ figure }: { figure: FigureLine }) {
  const { limit, unit } = figure;
  const [judging, other] = uncertainties(figure);
  const U = judging.value;
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
        {U > 0 && <span>{stated(judging, unit)}</span>}
        {other && <span>{stated(other, unit)}</span>}
      </p>
    </li>
  );
}
