import type { BudgetRow, CalibrationResult } from "../api/resultTypes";
import { bound } from "../parts/format";
import { lengthFigures, measured, unitOf } from "../parts/lengths";
import { said, t } from "../state/language";
import styles from "./Budget.module.css";

/** Where the uncertainty comes from, the largest first, and what changed since the last time. */
export function Budget({ result }: { result: CalibrationResult }) {
  const rows = [...result.budget].sort((a, b) => b.value_um - a.value_um);
  const largest = Math.max(result.total_um, 1e-9);
  return (
    <div className={styles.budget}>
      <h3 className={styles.title}>{bound(t("Standard uncertainty of a scanned point, k = 1"))}</h3>
      <div className={styles.rows}>
        {rows.map((row) => (
          <Row key={row.source} row={row} largest={largest} />
        ))}
        <Row row={{ source: t("Together"), value_um: result.total_um }} largest={largest} total />
      </div>
      {result.good_um !== null && result.usable_um !== null && (
        <p className={styles.limits}>
          {t("Good up to {good}, usable up to {usable}.", { good: measured(result.good_um, "µm"), usable: measured(result.usable_um, "µm") })}
        </p>
      )}
      <Compared result={result} />
    </div>
  );
}

function Row({ row, largest, total = false }: { row: BudgetRow; largest: number; total?: boolean }) {
  return (
    <div className={styles.row} data-total={total || undefined}>
      <span className={styles.source}>{row.source}</span>
      <span className={styles.track}>
        <span className={styles.bar} style={{ width: `${Math.min(100, (row.value_um / largest) * 100)}%` }} />
      </span>
      <span className={styles.value}>{micrometres(row.value_um)} {unitOf("µm")}</span>
    </div>
  );
}

/** Whole ones; a share too small for one is not called none. */
function micrometres(value: number): string {
  return value > 0 && value < 0.5 ? `< ${lengthFigures(1, "µm")}` : lengthFigures(value, "µm");
}

function Compared({ result }: { result: CalibrationResult }) {
  const { comparison } = result;
  return (
    <div className={styles.compared}>
      <h3 className={styles.title}>{t("Against the last calibration")}</h3>
      {comparison ? (
        <p>
          {t("Points of the measuring volume moved by {rms} rms, {most} at most, since {name}.", {
            rms: measured(comparison.rms_um, "µm"),
            most: measured(comparison.max_um, "µm"),
            name: said(comparison.with_name),
          })}
        </p>
      ) : (
        <p>{t("This is the first one. The next is compared with it here.")}</p>
      )}
    </div>
  );
}
