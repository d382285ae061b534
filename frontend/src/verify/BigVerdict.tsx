import type { ReactNode } from "react";

import type { VerdictLine, VerificationSummary } from "../api/verifyTypes";
import { moment, plural } from "../parts/format";
import { QualityMark } from "../parts/QualityMark";
import styles from "./BigVerdict.module.css";
import { QUALITY } from "./shown";

const TITLE = { pass: "Passed", fail: "Failed", uncertain: "Uncertain" };

/** The verdict, readable from two metres. */
export function Verdict({ result, text, children }: VerdictLine & { children?: ReactNode }) {
  return (
    <div className={styles.verdict} data-result={result} data-verdict>
      <p className={styles.title}>
        <QualityMark quality={QUALITY[result]} size="2rem" />
        {TITLE[result]}
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
        {summary.gauge}, {plural(summary.clouds, "cloud")}
        {summary.touched ? ", compared with the probe" : ""} · {moment(summary.accepted_at)}
        {summary.operator && ` · ${summary.operator}`}
      </p>
      <p className={styles.detail}>of {summary.calibration}</p>
    </Verdict>
  );
}
