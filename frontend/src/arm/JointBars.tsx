import type { JointSwing } from "../api/wire";
import { figures } from "../controls/format";
import { word } from "../state/language";
import styles from "./JointBars.module.css";

/** The range of each joint in this seat, within its limits. */
export function JointBars({ joints }: { joints: JointSwing[] }) {
  return (
    <dl className={styles.joints}>
      {joints.map((joint) => (
        <div key={joint.name} className={styles.joint}>
          <dt>{word(joint.name)}</dt>
          <dd>
            <span className={styles.track}>
              {joint.lowest_deg !== null && joint.highest_deg !== null && (
                <span
                  className={styles.swing}
                  style={{
                    left: `${share(joint, joint.lowest_deg)}%`,
                    width: `${share(joint, joint.highest_deg) - share(joint, joint.lowest_deg)}%`,
                  }}
                />
              )}
              {joint.now_deg !== null && (
                <span className={styles.now} style={{ left: `${share(joint, joint.now_deg)}%` }} />
              )}
            </span>
            <span className={styles.value}>{swing(joint)}</span>
          </dd>
        </div>
      ))}
    </dl>
  );
}

function share({ limit_low_deg, limit_high_deg }: JointSwing, angle_deg: number): number {
  const part = (angle_deg - limit_low_deg) / (limit_high_deg - limit_low_deg);
  return 100 * Math.min(1, Math.max(0, part));
}

function swing({ lowest_deg, highest_deg }: JointSwing): string {
  return lowest_deg === null || highest_deg === null ? "–" : `${figures(highest_deg - lowest_deg)}°`;
}
