import { useEffect, useRef, useState } from "react";

import type { TrialView } from "../api/wire";
import { figures } from "../controls/format";
import { measured } from "../controls/lengths";
import { t } from "../state/language";
import styles from "./Devices.module.css";
import { Waiting } from "./TrialPicture";

/** What moves by more than this, in degrees or mm, between two looks is marked for a moment. */
const MOVES = 0.05;
const MARKED_MS = 600;

/** The joints or the pose of the arm, as it is moved. */
export function JointDials({ trial }: { trial: TrialView }) {
  const { joints_deg, position_mm, rotation_deg } = trial;
  const values = position_mm && rotation_deg ? [...position_mm, ...rotation_deg] : joints_deg;
  const moving = useMoving(values);
  if (values.length === 0 || trial.state === "failed" || trial.state === "ended") return <Waiting trial={trial} />;
  return (
    <div className={styles.dials}>
      <p className={styles.hint}>{t("ui-move-the-arm-every-value-must-follow")}</p>
      <ul className={styles.rows}>
        {values.map((value, i) => (
          <li key={nameOf(trial, i)} className={styles.dial} data-moving={moving[i] || undefined}>
            <span className={styles.joint}>{nameOf(trial, i)}</span>
            {!position_mm && (
              <svg viewBox="-12 -12 24 24" className={styles.needle} aria-hidden="true">
                <circle r="10.5" />
                <path d="M0 0V-9" transform={`rotate(${value})`} />
              </svg>
            )}
            <span className={styles.angle}>
              {position_mm && i < 3 ? measured(value, "mm", 2) : `${figures(value, 2)}°`}
            </span>
          </li>
        ))}
      </ul>
    </div>
  );
}

function nameOf({ position_mm }: TrialView, index: number): string {
  if (!position_mm) return t("ui-joint-n", { n: index + 1 });
  return ["X", "Y", "Z", "Rx", "Ry", "Rz"][index] ?? "";
}

/** Which values have just changed. */
function useMoving(values: number[]): boolean[] {
  const before = useRef<number[]>([]);
  const movedAt = useRef<number[]>([]);
  const [moving, setMoving] = useState<boolean[]>([]);
  useEffect(() => {
    const now = performance.now();
    values.forEach((value, i) => {
      if (Math.abs(value - (before.current[i] ?? value)) > MOVES) movedAt.current[i] = now;
    });
    before.current = values;
    setMoving(values.map((_, i) => now - (movedAt.current[i] ?? -MARKED_MS) < MARKED_MS));
  }, [values]);
  return moving;
}
