import type { DimensionLine } from "../api/wire";
import styles from "./DeviationBar.module.css";
import { spreadOf } from "./outcomes";

const WIDTH = 200;
const HEIGHT = 26;
const MIDDLE = HEIGHT / 2;

/** Where the value lies against its limits, with U as a whisker. The words are beside it. */
export function DeviationBar({ line }: { line: DimensionLine }) {
  const { lower, upper, decision } = line;
  if (lower === null && upper === null) return null;
  const off = line.value - line.nominal;
  const spread = spreadOf(line) ?? 0;
  const low = lower ?? (upper !== null && upper > 0 ? 0 : -Math.abs(upper ?? 0));
  const high = upper ?? (lower !== null && lower < 0 ? 0 : Math.abs(lower ?? 0));
  const room = 0.35 * Math.max(high - low, 1e-9);
  const from = Math.min(low - room, off - spread);
  const to = Math.max(high + room, off + spread);
  const x = (value: number) => 4 + ((WIDTH - 8) * (value - from)) / (to - from);
  return (
    <svg
      className={styles.bar}
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      preserveAspectRatio="xMinYMid"
      data-decision={decision}
      aria-hidden="true"
    >
      <line className={styles.axis} x1={0} x2={WIDTH} y1={MIDDLE} y2={MIDDLE} />
      <rect className={styles.zone} x={x(low)} width={x(high) - x(low)} y={4} height={HEIGHT - 8} rx={3} />
      {low < 0 && high > 0 && <line className={styles.zero} x1={x(0)} x2={x(0)} y1={4} y2={HEIGHT - 4} />}
      <line className={styles.whisker} x1={x(off - spread)} x2={x(off + spread)} y1={MIDDLE} y2={MIDDLE} />
      {[-1, 1].map((side) => (
        <line
          key={side}
          className={styles.whisker}
          x1={x(off + side * spread)}
          x2={x(off + side * spread)}
          y1={MIDDLE - 4}
          y2={MIDDLE + 4}
        />
      ))}
      <circle className={styles.value} cx={x(off)} cy={MIDDLE} r={5} />
    </svg>
  );
}
