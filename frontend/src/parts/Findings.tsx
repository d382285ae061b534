import type { Finding } from "../api/types";
import { bound } from "./format";
import styles from "./Findings.module.css";
import { QualityMark } from "./QualityMark";

/** What the station found, each with its number, its limit and what to do. */
export function Findings({ findings }: { findings: Finding[] }) {
  if (findings.length === 0) return null;
  return (
    <ul className={styles.list} aria-label="Findings">
      {findings.map((finding) => (
        <li key={finding.text} className={styles.finding} data-quality={finding.quality}>
          <QualityMark quality={finding.quality} size="1.25rem" />
          <div>
            <p className={styles.text}>{bound(finding.text)}</p>
            {finding.remedy && <p className={styles.remedy}>{bound(finding.remedy)}</p>}
          </div>
        </li>
      ))}
    </ul>
  );
}
