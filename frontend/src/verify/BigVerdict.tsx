import type { ReactNode } from "react";

import type { VerdictLine, VerificationSummary } from "../api/verifyTypes";
import { moment } from "../parts/format";
import { QualityMark } from "../parts/QualityMark";
import { isolated } from "../state/isolated";
import { counted, said, t, words } from "../state/language";
import styles from "./BigVerdict.module.css";
import { QUALITY } from "./shown";

const TITLE = { pass: words("Passed"), fail: words("Failed"), uncertain: words("Uncertain") };

/** The verdict, readable from two metres. */
export function Verdict({ result, text, children }: VerdictLine & { children?: ReactNode }) {
  return (
    <div className={styles.verdict} data-result={result} data-verdict>
      <p className={styles.title}>
        <QualityMark quality={QUALITY[result]} size="2rem" />
        {t(TITLE[result])}
      </p>
      <p>{text}</p>
      {children}
    </div>
  );
}

/** A record's verdict, with what it is of. */
export function BigVerdict({ summary }: { summary: VerificationSummary }) {
  return (
    <Verdict {...summary}>
      <p className={styles.detail}>
        {said(summary.gauge)}, {counted(summary.clouds, "{n} cloud", "{n} clouds")}
        {summary.touched ? `, ${t("compared with the probe")}` : ""} · {moment(summary.accepted_at)}
        {summary.operator && ` · ${isolated(summary.operator)}`}
      </p>
      <p className={styles.detail}>{t("of {calibration}", { calibration: said(summary.calibration) })}</p>
    </Verdict>
  );
}
