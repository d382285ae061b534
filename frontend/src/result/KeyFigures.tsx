import type { CalibrationResult } from "../api/types";
import { figures } from "../parts/format";
import styles from "./KeyFigures.module.css";

/** The figures that a metrologist looks for first. */
export function KeyFigures({ result }: { result: CalibrationResult }) {
  const [near, far] = result.depth_range_mm;
  const rows: [string, string, string][] = [
    ["Corners, rms", figures(result.reprojection_rms_px, 3), "px"],
    ["Laser plane, rms", figures(result.laser_plane_rms_um, 1), "µm"],
    ["Touches, rms", figures(result.alignment_rms_um), "µm"],
    ["Depth range", `${figures(near, 1)} to ${figures(far, 1)}`, "mm"],
    ["Condition", figures(result.condition_number, 1), "of 50"],
  ];
  return (
    <dl className={styles.figures}>
      {rows.map(([label, value, unit]) => (
        <div key={label} className={styles.figure}>
          <dt>{label}</dt>
          <dd>
            {value} <span>{unit}</span>
          </dd>
        </div>
      ))}
    </dl>
  );
}
