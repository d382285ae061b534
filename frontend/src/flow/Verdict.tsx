import type { CalibrationResult } from "../api/types";
import { bound } from "../parts/format";
import { QualityMark } from "../parts/QualityMark";
import styles from "./Verdict.module.css";

/** One verdict, with its reason. */
export function Verdict({ result }: { result: CalibrationResult }) {
  return (
    <div className={styles.verdict} data-quality={result.verdict}>
      <QualityMark quality={result.verdict} size="2.25rem" />
      <p className={styles.text}>{bound(result.verdict_text)}</p>
    </div>
  );
}
