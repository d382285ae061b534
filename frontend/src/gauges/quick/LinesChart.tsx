import { lengthFigures, measured } from "../../controls/lengths";
import { limitBeside } from "../../controls/limits";
import { quantity } from "../../messages/text";
import { t } from "../../state/language";
import styles from "./Charts.module.css";

export interface Line {
  name: string;
  values: number[];
  colour: string;
}

interface LinesChartProps {
  title: string;
  unit: string;
  lines: Line[];
  /** Under the points, from left to right. */
  labels: string[];
  limit?: number | null | undefined;
  /** Both signs are possible. */
  both?: boolean;
}

const WIDTH = 600;
const HEIGHT = 200;
const EDGE = 26;

/** A quantity over clouds, one line per calibration (article, Figs. 7, 8 and 11). */
export function LinesChart({ title, unit, lines, labels, limit = null, both = false }: LinesChartProps) {
  const all = lines.flatMap(({ values }) => values);
  const largest = Math.max(...all.map(Math.abs), 1);
  /* A far limit does not flatten the points: it is then in the text alone. */
  const drawn = limit !== null && limit < 4 * largest ? limit : null;
  const top = 1.15 * Math.max(largest, drawn ?? 0);
  const low = both ? -top : 0;
  const x = (i: number) => (labels.length === 1 ? WIDTH / 2 : EDGE + (i * (WIDTH - 2 * EDGE)) / (labels.length - 1));
  const y = (value: number) => HEIGHT - (HEIGHT * (value - low)) / (top - low);
  return (
    <figure className={styles.chart}>
      <figcaption className={styles.title}>
        {title}
        {limit !== null && (
          <span className={styles.limitWords}>
            {t("ui-limit-value", { value: limitBeside(limit, unit) })},{" "}
            {drawn === null ? t("ui-beyond-the-chart") : t("ui-dashed")}
          </span>
        )}
      </figcaption>
      <div className={styles.plotted}>
        <div className={styles.scale} aria-hidden="true">
          <span>
            {both && "+"}
            {measured(top, unit)}
          </span>
          {both && <span>0</span>}
          <span>{both ? `−${lengthFigures(top, unit)}` : "0"}</span>
        </div>
        <svg
          className={styles.plot}
          viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
          preserveAspectRatio="none"
          role="img"
          aria-label={title}
        >
          {both && <line className={styles.zero} x1={0} x2={WIDTH} y1={y(0)} y2={y(0)} />}
          {drawn !== null &&
            (both ? [-drawn, drawn] : [drawn]).map((value) => (
              <line key={value} className={styles.limit} x1={0} x2={WIDTH} y1={y(value)} y2={y(value)} />
            ))}
          {lines.map((line) => (
            <polyline
              key={line.name}
              className={styles.line}
              style={{ stroke: line.colour }}
              points={line.values.map((value, i) => `${x(i)},${y(value)}`).join(" ")}
            />
          ))}
          {lines.map((line) =>
            line.values.map((value, i) => (
              <line
                key={`${line.name}${i}`}
                className={styles.dot}
                style={{ stroke: line.colour }}
                x1={x(i)}
                x2={x(i)}
                y1={y(value)}
                y2={y(value)}
              >
                <title>{`${line.name}, ${labels[i] ?? ""}: ${measured(value, unit, 1)}`}</title>
              </line>
            )),
          )}
        </svg>
      </div>
      <div className={styles.axis} aria-hidden="true">
        <span>{t("ui-cloud")}</span>
        <div className={styles.labels} style={labels.length === 1 ? { justifyContent: "center" } : undefined}>
          {labels.map((label) => (
            <span key={label}>{label}</span>
          ))}
        </div>
      </div>
    </figure>
  );
}

interface RangeBarsProps {
  title: string;
  unit: string;
  bars: { name: string; value: number; colour: string }[];
}

/** A range for each calibration, or for each cloud (article, Figs. 9 and 10). */
export function RangeBars({ title, unit, bars }: RangeBarsProps) {
  const top = Math.max(...bars.map(({ value }) => value), 1e-6);
  const mean = bars.reduce((sum, { value }) => sum + value, 0) / Math.max(bars.length, 1);
  return (
    <figure className={styles.chart}>
      <figcaption className={styles.title}>
        {title}
        <span className={styles.limitWords}>{t("ui-mean", { value: quantity(mean, unit, 1) })}</span>
      </figcaption>
      <ul className={styles.bars}>
        {bars.map(({ name, value, colour }) => (
          <li key={name} className={styles.barRow}>
            <span className={styles.barName}>{name}</span>
            <span className={styles.barTrack}>
              <span className={styles.bar} style={{ width: `${(100 * value) / top}%`, background: colour }} />
            </span>
            <span className={styles.barValue}>{measured(value, unit, 1)}</span>
          </li>
        ))}
      </ul>
    </figure>
  );
}
