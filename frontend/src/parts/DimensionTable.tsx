import type { DimensionLine } from "../api/wire";
import { QualityMark } from "../controls/QualityMark";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { DeviationBar } from "./DeviationBar";
import styles from "./DimensionTable.module.css";
import { OUTCOME_QUALITY, OUTCOMES, shown, shownDeviation } from "./outcomes";

/** Every dimension with its nominal, its limits, its value with U, and the word. */
export function DimensionTable({ lines }: { lines: readonly DimensionLine[] }) {
  return (
    <table className={styles.table}>
      <thead>
        <tr>
          <th scope="col">{t("ui-part-dimension")}</th>
          <th scope="col">{t("ui-part-nominal-and-limits")}</th>
          <th scope="col">{t("ui-value")}</th>
          <th scope="col" className={styles.wide}>
            {t("ui-part-deviation")}
          </th>
          <th scope="col">{t("ui-part-decision")}</th>
        </tr>
      </thead>
      <tbody>
        {lines.map((line) => (
          <tr key={line.id} data-dimension={line.id}>
            <th scope="row">
              <span className={styles.id}>{isolated(line.id)}</span>
              <span className={styles.small}>{line.title}</span>
            </th>
            <td>
              {shown(line.nominal, line)}
              <span className={styles.small}>{limitsOf(line)}</span>
            </td>
            <td>
              <strong>{shown(line.value, line)}</strong>
              <span className={styles.small}>{spreadText(line)}</span>
            </td>
            <td className={styles.wide}>
              <DeviationBar line={line} />
            </td>
            <td>
              <span className={styles.decision}>
                <QualityMark quality={OUTCOME_QUALITY[line.decision]} size="1.25rem" />
                {t(OUTCOMES[line.decision])}
              </span>
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** Limits as deviations: "± 0.1", or both. */
export function limitsOf(line: DimensionLine): string {
  const { lower, upper } = line;
  if (lower === null && upper === null) return t("ui-part-without-limits");
  if (lower !== null && upper !== null && lower === -upper) return `± ${shown(upper, line)}`;
  return [lower, upper].flatMap((limit) => (limit === null ? [] : [shownDeviation(limit, line)])).join(" … ");
}

export function spreadText(line: DimensionLine): string {
  if (line.expanded !== null) return `U = ${shown(line.expanded, line)}`;
  return line.scatter === null ? "" : t("ui-part-scatter-of", { value: shown(line.scatter, line) });
}
