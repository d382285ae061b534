import type { DriftPoint, DriftStep } from "../api/wire";
import { figures, moment } from "../parts/format";
import { qualityOf } from "./answers";
import styles from "./FleetPage.module.css";

const WIDTH = 1000;
const HEIGHT = 160;
const EDGE = 10;

interface Range {
  from: number;
  to: number;
  low: number;
  high: number;
}

/** A figure over time with its limit; bands are where a change happened (95 %). */
export function DriftChart({
  points,
  changes,
  range,
  label,
}: {
  points: DriftPoint[];
  changes: DriftStep[];
  range: Range;
  label: string;
}) {
  const margin = 0.08 * Math.max(range.high - range.low, 1e-9);
  const low = range.low - margin;
  const high = range.high + margin;
  const x = (at: string) =>
    EDGE + ((WIDTH - 2 * EDGE) * (Date.parse(at) - range.from)) / Math.max(range.to - range.from, 1);
  const y = (value: number) => HEIGHT - (HEIGHT * (value - low)) / (high - low);
  const limit = points.flatMap((one) => (one.limit === null ? [] : [one.limit]))[0];
  const unit = points[0]?.unit ?? "";
  return (
    <figure className={styles.chart}>
      <div className={styles.scale} aria-hidden="true">
        <span>{`${figures(high, 1)} ${unit}`}</span>
        <span>{figures(low, 1)}</span>
      </div>
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} preserveAspectRatio="none" role="img" aria-label={label}>
        {changes.map((one) => (
          <rect
            key={one.by}
            className={styles.band}
            x={x(one.earliest)}
            width={Math.max(x(one.latest) - x(one.earliest), 3)}
            y="0"
            height={HEIGHT}
          />
        ))}
        {limit !== undefined && <line className={styles.limit} x1="0" x2={WIDTH} y1={y(limit)} y2={y(limit)} />}
        <polyline className={styles.line} points={points.map((one) => `${x(one.at)},${y(one.value)}`).join(" ")} />
        {points.map((one) => (
          <circle
            key={one.record_key}
            className={styles.dot}
            data-quality={qualityOf(one.decision)}
            cx={x(one.at)}
            cy={y(one.value)}
            r="4"
          >
            <title>{`${moment(one.at)}: ${figures(one.value, 2)} ${one.unit}`}</title>
          </circle>
        ))}
      </svg>
      <figcaption className={styles.dates}>
        <span>{moment(new Date(range.from).toISOString())}</span>
        <span>{moment(new Date(range.to).toISOString())}</span>
      </figcaption>
    </figure>
  );
}
