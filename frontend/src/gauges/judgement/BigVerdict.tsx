import type { ReactNode } from "react";

import type { VerdictLine, VerificationSummary } from "../../api/wire";
import { moment } from "../../controls/format";
import { QualityMark } from "../../controls/QualityMark";
import { isolated } from "../../state/isolated";
import { t } from "../../state/language";
import { QUALITY } from "../quick/verification";
import styles from "./BigVerdict.module.css";

const TITLES = { pass: "ui-passed", fail: "ui-failed", uncertain: "ui-uncertain" } as const;

/** The verdict, readable from two metres. */
export function Verdict({ result, text, children }: VerdictLine & { children?: ReactNode }) {
  return (
    <div className={styles.verdict} data-result={result} data-verdict>
      <p className={styles.title}>
        <QualityMark quality={QUALITY[result]} size="2rem" />
        {t(TITLES[result])}
      </p>
      <p>{text}</p>
      {children}
    </div>
  );
}

/** The verdict of a record, with its subject. */
export function BigVerdict({ summary }: { summary: VerificationSummary }) {
  return (
    <Verdict {...summary}>
      <p className={styles.detail}>
        {isolated(summary.gauge)}, {t("ui-n-clouds", { n: summary.clouds })}
        {summary.touched ? `, ${t("ui-compared-with-the-probe")}` : ""} · {moment(summary.accepted_at)}
        {summary.operator && ` · ${isolated(summary.operator)}`}
      </p>
      <p className={styles.detail}>{t("ui-of", { calibration: summary.calibration })}</p>
    </Verdict>
  );
}
