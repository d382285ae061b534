import type { Quality } from "../api/types";
import { t } from "../state/language";
import { moment } from "./format";
import { measured } from "./lengths";
import styles from "./TimeChart.module.css";

const WIDTH = 800;
const HEIGHT = 200;
const EDGE = 14;

export interface TimePoint {
  id: string;
  at: string;
  value: number | null;
  limit: number | null;
  /** Expanded: drawn as a bar on both sides. */
  uncertainty?: number | null;
  quality: Quality;
}

interface TimeChartProps {
  /** The oldest first. */
  points: TimePoint[];
  unit: string;
  label: string;
  /** Values have a sign, and limits stand on both sides of zero. */
  signed?: boolean;
  onPoint?: (id: string) => void;
}

/** A quantity over time, with dashed limits; a bad value is drawn as a cross. */
export function TimeChart({ points, unit, label, signed = false, onPoint }: TimeChartProps) {
  const known = points.flatMap(({ value, limit, uncertainty }) => [
    Math.abs(value ?? 0) + (value === null ? 0 : (uncertainty ?? 0)),
    limit ?? 0,
  ]);
  const top = 1.15 * Math.max(...known, 1);
  const bottom = signed ? -top : 0;
  const step = (WIDTH - 2 * EDGE) / Math.max(points.length - 1, 1);
  const x = (i: number) => (points.length === 1 ? WIDTH / 2 : EDGE + i * step);
  const y = (value: number) => (HEIGHT * (top - value)) / (top - bottom);
  /* A limit is its own point's, and holds half-way to the next. */
  const reach = points.length === 1 ? 30 : step / 2;
  const pressed = Math.min(22, reach);
  const first = points[0];
  const last = points[points.length - 1];
  const line = points.flatMap(({ value }, i) => (value === null ? [] : [`${x(i)},${y(value)}`]));
  return (
    <figure className={styles.chart}>
      <div className={styles.plotted}>
        <div className={styles.scale} aria-hidden="true">
          <span>{measured(top, unit, top < 10 ? 1 : 0)}</span>
          <span>0</span>
          {signed && <span>{measured(bottom, unit, top < 10 ? 1 : 0)}</span>}
        </div>
        <svg className={styles.plot} viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={label}>
          {signed && <line className={styles.zero} x1={0} x2={WIDTH} y1={y(0)} y2={y(0)} />}
          <polyline className={styles.line} points={line.join(" ")} />
          {points.map(({ id, at, value, limit, uncertainty, quality }, i) => (
            <g key={id} className={onPoint && styles.point} onClick={() => onPoint?.(id)}>
              <title>{`${moment(at)}: ${value === null ? t("ui-unknown") : measured(value, unit, 1)}`}</title>
              {onPoint && (
                <rect x={x(i) - pressed} y="0" width={2 * pressed} height={HEIGHT} className={styles.reach} />
              )}
              {(limit === null ? [] : signed ? [limit, -limit] : [limit]).map((at) => (
                <line key={at} className={styles.limit} x1={x(i) - reach} x2={x(i) + reach} y1={y(at)} y2={y(at)} />
              ))}
              {value !== null && uncertainty != null && (
                <line
                  className={styles.bar}
                  x1={x(i)}
                  x2={x(i)}
                  y1={y(Math.max(value - uncertainty, bottom))}
                  y2={y(value + uncertainty)}
                />
              )}
              {value !== null && <Mark x={x(i)} y={y(value)} quality={quality} />}
            </g>
          ))}
        </svg>
      </div>
      {first && last && (
        <figcaption className={styles.dates}>
          <span>{moment(first.at)}</span>
          {points.length > 1 && <span>{moment(last.at)}</span>}
        </figcaption>
      )}
    </figure>
  );
}

function Mark({ x, y, quality }: { x: number; y: number; quality: Quality }) {
  if (quality === "bad") {
    return <path className={styles.failed} d={`M${x - 6} ${y - 6}l12 12M${x + 6} ${y - 6}l-12 12`} />;
  }
  return <circle className={styles.dot} data-quality={quality} cx={x} cy={y} r={5.5} />;
}
