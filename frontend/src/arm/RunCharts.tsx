import type { ArmPicture } from "../api/wire";
import { measured } from "../controls/lengths";
import { limitBeside } from "../controls/limits";
import { t } from "../state/language";
import styles from "./RunCharts.module.css";

const AXES = ["X", "Y", "Z"];
const WIDTH = 600;
const HEIGHT = 120;
const LEAST_UM = 10;

/** The position of the tip along each axis of the arm, point by point, with the limits. */
export function RunCharts({ picture, touching = false }: { picture: ArmPicture; touching?: boolean }) {
  const { tips_um, half_range_um, two_sigma_um, limit_um, largest_um, two_s_um } = picture;
  const largest = Math.max(LEAST_UM, ...(half_range_um ?? []));
  /* A far limit does not flatten the points: it is then in the text alone. */
  const limit = limit_um !== null && limit_um < 4 * largest ? limit_um : null;
  const reach = 1.15 * Math.max(largest, limit ?? 0);
  return (
    <div className={styles.charts}>
      {typeof largest_um === "number" && (
        <p className={styles.caption}>
          <span className={styles.axis}>{t("ui-in-space")}</span>
          <Value label={t("ui-largest-distance-from-mean")} value={largest_um} />
          <Value label="2s" value={two_s_um ?? undefined} />
        </p>
      )}
      {AXES.map((axis, k) => (
        <figure key={axis} className={styles.chart}>
          <figcaption className={styles.caption}>
            <span className={styles.axis}>{axis}</span>
            <Value label="(max − min)/2" value={half_range_um?.[k]} />
            <Value label="2σ" value={two_sigma_um?.[k]} />
          </figcaption>
          <svg
            className={styles.plot}
            viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
            preserveAspectRatio="none"
            role="img"
            aria-label={t("ui-the-tip-along-points", { axis, n: tips_um.length })}
          >
            <line className={styles.middle} x1={0} x2={WIDTH} y1={HEIGHT / 2} y2={HEIGHT / 2} />
            {limit !== null &&
              [-1, 1].map((side) => (
                <line
                  key={side}
                  className={styles.limit}
                  x1={0}
                  x2={WIDTH}
                  y1={at(side * limit, reach)}
                  y2={at(side * limit, reach)}
                />
              ))}
            <polyline
              className={styles.line}
              points={tips_um.map((tip, i) => `${across(i, tips_um.length)},${at(tip[k] ?? 0, reach)}`).join(" ")}
            />
          </svg>
          <div className={styles.scale} aria-hidden="true">
            <span>+{measured(reach, "µm")}</span>
            <span>−{measured(reach, "µm")}</span>
          </div>
        </figure>
      ))}
      <p className={styles.note}>
        {tips_um.length > 1
          ? t("ui-last-points-order-capture-about-mean", { n: tips_um.length })
          : touching
            ? t("ui-points-appear-fifth-contact-point")
            : t("ui-points-appear-arm-swings")}
        {limit !== null && ` ${t("ui-dashed-the-limit", { value: limitBeside(limit, "µm") })}`}
      </p>
    </div>
  );
}

function across(i: number, count: number): number {
  return (WIDTH * (i + 0.5)) / Math.max(count, 60);
}

function at(value_um: number, reach: number): number {
  return HEIGHT / 2 - ((HEIGHT / 2) * value_um) / reach;
}

function Value({ label, value }: { label: string; value: number | undefined }) {
  return (
    <span className={styles.value}>
      <span className={styles.name}>{label}</span>
      <strong>{value === undefined ? "–" : measured(value, "µm")}</strong>
    </span>
  );
}
