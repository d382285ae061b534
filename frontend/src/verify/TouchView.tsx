import type { TouchLine } from "../api/verifyTypes";
import legend from "../flow/ResidualLegend.module.css";
import { RAMP_CSS, rampColour } from "../object/residuals";
import { figures } from "../parts/format";
import { measured, roundEnd, signedLength } from "../parts/lengths";
import { t } from "../state/language";
import { GaugeDrawing } from "./GaugeDrawing";
import styles from "./TouchView.module.css";

interface TouchViewProps {
  picture: { shape: "plane" | "sphere" | null; radius_mm: number | null; touches: TouchLine[] };
}

/** Where the gauge was touched, seen from above, and how far each touch is off it. */
export function TouchView({ picture }: TouchViewProps) {
  const placed = picture.touches.filter((touch) => touch.x_mm !== null);
  if (placed.length === 0) {
    return (
      <div className={styles.view}>
        <GaugeDrawing shape={picture.shape} touching />
        <p className={styles.words}>
          {picture.touches.length === 0 ? t("Touch where the dots are; the order does not matter.") : t("{n} taken. A few more, and they are drawn here.", { n: figures(picture.touches.length) })}
        </p>
      </div>
    );
  }
  const worst = Math.max(...placed.map(({ residual_um }) => Math.abs(residual_um ?? 0)));
  const end = roundEnd(worst, "µm", 5, 1000);
  const radius = picture.radius_mm;
  const reach = radius ?? Math.max(...placed.flatMap(({ x_mm, y_mm }) => [Math.abs(x_mm ?? 0), Math.abs(y_mm ?? 0)]));
  const half = 1.3 * reach;
  const dot = half / 28;
  return (
    <div className={styles.view}>
      <svg className={styles.plot} viewBox={`${-half} ${-half} ${2 * half} ${2 * half}`} role="img" aria-label={t("Touches, seen from above")}>
        {radius !== null ? (
          <circle r={radius} className={styles.gauge} />
        ) : (
          <rect x={-1.15 * reach} y={-1.15 * reach} width={2.3 * reach} height={2.3 * reach} rx={dot} className={styles.gauge} />
        )}
        {placed.map(({ index, x_mm, y_mm, residual_um }, i) => (
          <g key={index} transform={`translate(${x_mm ?? 0} ${-(y_mm ?? 0)})`}>
            <circle r={dot} style={{ fill: rampColour(Math.abs(residual_um ?? 0) / end) }} className={styles.dot} />
            <text x={1.5 * dot} y={0.55 * dot} fontSize={1.9 * dot} className={styles.label}>
              {i + 1}: {signedLength(residual_um ?? 0, "µm")}
            </text>
          </g>
        ))}
      </svg>
      <div className={legend.legend}>
        <span>0</span>
        <span className={legend.ramp} style={{ background: RAMP_CSS }} />
        <span>{t("{end} off the gauge that fits them best; outward is positive", { end: measured(end, "µm") })}</span>
      </div>
    </div>
  );
}
