import type { Finding } from "../api/wire";
import { t } from "../state/language";
import { lookAtPose, useLive } from "../state/store";
import styles from "./Findings.module.css";
import { QualityMark } from "./QualityMark";

/** The findings of the station, each with its value, its limit and its remedy. */
export function Findings({ findings }: { findings: Finding[] }) {
  if (findings.length === 0) return null;
  return (
    <ul className={styles.list} aria-label={t("ui-findings")}>
      {findings.map((finding) => (
        <li key={finding.quality + finding.text} className={styles.finding} data-quality={finding.quality}>
          <QualityMark quality={finding.quality} size="1.25rem" />
          <div>
            <p className={styles.text}>{finding.text}</p>
            {finding.remedy && <p className={styles.remedy}>{finding.remedy}</p>}
            {finding.pose !== null && <ShowPose pose={finding.pose} />}
          </div>
        </li>
      ))}
    </ul>
  );
}

/** Shows the pose that a finding concerns, if its picture is available. */
function ShowPose({ pose }: { pose: number }) {
  const there = useLive(({ flow }) => {
    const picture = flow?.picture;
    return (picture?.kind === "still" || picture?.kind === "result") && picture.poses.some((p) => p.number === pose);
  });
  if (!there) return null;
  return (
    <button type="button" className={styles.show} onClick={() => lookAtPose(pose)}>
      {t("ui-show-pose", { n: pose })}
    </button>
  );
}
