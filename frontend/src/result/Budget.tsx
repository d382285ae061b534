import type { BudgetLine, CalibrationResult } from "../api/wire";
import { lengthFigures, unitOf } from "../controls/lengths";
import { POINT_DECIMALS } from "../controls/uncertainty";
import { quantity } from "../messages/text";
import { t } from "../state/language";
import styles from "./Budget.module.css";

/** Where the uncertainty comes from, the largest first, and what changed since the last time. */
export function Budget({ result }: { result: CalibrationResult }) {
  const rows = [...result.budget].sort((a, b) => b.value_um - a.value_um);
  const largest = Math.max(result.total_um, 1e-9);
  return (
    <div className={styles.budget}>
      <h3 className={styles.title}>{t("ui-standard-uncertainty-of-a-scanned-point")}</h3>
      <div className={styles.rows}>
        {rows.map((row) => (
          <Row key={row.source} row={row} largest={largest} />
        ))}
        <Row row={{ source: t("ui-together"), value_um: result.total_um }} largest={largest} total />
      </div>
      {result.good_um !== null && result.usable_um !== null && (
        <p className={styles.limits}>
          {t("ui-good-up-to-usable-up-to", {
            good: quantity(result.good_um, "µm"),
            usable: quantity(result.usable_um, "µm"),
          })}
        </p>
      )}
      <Compared result={result} />
    </div>
  );
}

function Row({ row, largest, total = false }: { row: BudgetLine; largest: number; total?: boolean }) {
  return (
    <div className={styles.row} data-total={total || undefined}>
      <span className={styles.source}>{row.source}</span>
      <span className={styles.track}>
        <span className={styles.bar} style={{ width: `${Math.min(100, (row.value_um / largest) * 100)}%` }} />
      </span>
      <span className={styles.value}>
        {micrometres(row.value_um)} {unitOf("µm")}
      </span>
    </div>
  );
}

/** As in the report; a share that is there is not shown as zero. */
function micrometres(value: number): string {
  const least = 10 ** -POINT_DECIMALS;
  const figures = lengthFigures(Math.max(value, least), "µm", POINT_DECIMALS);
  return value > 0 && value < least / 2 ? `< ${figures}` : lengthFigures(value, "µm", POINT_DECIMALS);
}

function Compared({ result }: { result: CalibrationResult }) {
  const { comparison } = result;
  return (
    <div className={styles.compared}>
      <h3 className={styles.title}>{t("ui-against-the-last-calibration")}</h3>
      {comparison ? (
        <p>
          {t("ui-points-measuring-volume-moved-rms-most", {
            rms: quantity(comparison.rms_um, "µm"),
            most: quantity(comparison.max_um, "µm"),
            name: comparison.with_name,
          })}
        </p>
      ) : (
        <p>{t("ui-first-calibration-next-one-compared")}</p>
      )}
    </div>
  );
}
