import type { PerformanceSummary } from "../../api/wire";
import { moment } from "../../controls/format";
import rows from "../../controls/List.module.css";
import { PressButton } from "../../controls/PressButton";
import { QualityMark } from "../../controls/QualityMark";
import { Reports } from "../../controls/Reports";
import type { PlainId } from "../../messages/text";
import styles from "../../records/Rows.module.css";
import { isolated } from "../../state/isolated";
import { t } from "../../state/language";
import { go } from "../../state/router";

export const RESULTS: Record<PerformanceSummary["result"], PlainId> = {
  pass: "ui-pass",
  fail: "ui-fail",
  uncertain: "ui-uncertain",
  cancelled: "ui-cancelled",
};
export const RESULT_QUALITY = { pass: "good", fail: "bad", uncertain: "attention", cancelled: "neutral" } as const;

/** A performance test in a list, with its verdict or why it was cancelled. */
export function PerformanceRow({ summary }: { summary: PerformanceSummary }) {
  return (
    <li className={`${rows.row} ${styles.row}`}>
      <QualityMark quality={RESULT_QUALITY[summary.result]} />
      <div className={styles.what}>
        <p className={rows.name}>
          {t(RESULTS[summary.result])}: {isolated(summary.artefact)}
        </p>
        <p className={rows.detail}>
          {moment(summary.ended_at)} · {summary.text}
          {summary.operator && ` · ${isolated(summary.operator)}`}
        </p>
      </div>
      {summary.result !== "cancelled" && (
        <>
          <PressButton free onPress={() => go("performance", summary.id)}>
            {t("ui-open")}
          </PressButton>
          <Reports of={`/api/performances/${summary.id}`} />
        </>
      )}
    </li>
  );
}
