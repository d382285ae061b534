import type { ArmCheckSummary } from "../api/armTypes";
import { figures, moment } from "../parts/format";
import styles from "./History.module.css";

const SHOWN = 40;
const WIDTH = 800;
const HEIGHT = 200;
const EDGE = 14;

/** The last checks from left to right, the limits dashed; a failed one is drawn as a cross. */
export function HistoryChart({ checks }: { checks: ArmCheckSummary[] }) {
  const shown = checks.slice(0, SHOWN).reverse();
  const values = shown.map((check) => Math.max(...check.half_range_um));
  const top = 1.15 * Math.max(...values, ...shown.map((check) => check.limit_um ?? 0), 1);
  const step = (WIDTH - 2 * EDGE) / Math.max(shown.length - 1, 1);
  const x = (i: number) => (shown.length === 1 ? WIDTH / 2 : EDGE + i * step);
  const y = (value: number) => HEIGHT - (HEIGHT * value) / top;
  const first = shown[0];
  const last = shown[shown.length - 1];
  return (
    <figure className={styles.chart}>
      <div className={styles.plotted}>
        <div className={styles.scale} aria-hidden="true">
          <span>{figures(top)} µm</span>
          <span>0</span>
        </div>
        <svg className={styles.plot} viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label="The checks over time">
          <polyline className={styles.line} points={values.map((value, i) => `${x(i)},${y(value)}`).join(" ")} />
          {shown.map((check, i) => (
            <g key={check.id}>
              {check.limit_um !== null && (
                <line
                  className={styles.limit}
                  x1={x(i) - Math.min(step, 60) / 2}
                  x2={x(i) + Math.min(step, 60) / 2}
                  y1={y(check.limit_um)}
                  y2={y(check.limit_um)}
                />
              )}
              <Mark x={x(i)} y={y(values[i] ?? 0)} check={check} />
            </g>
          ))}
        </svg>
      </div>
      {first && last && (
        <figcaption className={styles.dates}>
          <span>{moment(first.at)}</span>
          {shown.length > 1 && <span>{moment(last.at)}</span>}
        </figcaption>
      )}
    </figure>
  );
}

function Mark({ x, y, check }: { x: number; y: number; check: ArmCheckSummary }) {
  if (check.verdict === "bad") {
    return <path className={styles.failed} d={`M${x - 6} ${y - 6}l12 12M${x + 6} ${y - 6}l-12 12`} />;
  }
  return <circle className={styles.dot} data-quality={check.verdict} cx={x} cy={y} r={5.5} />;
}
