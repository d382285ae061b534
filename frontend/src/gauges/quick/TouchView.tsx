import { useElementSize } from "@mantine/hooks";
import type { TouchLine } from "../../api/wire";
import { DEVIATION_CSS, deviationColour } from "../../controls/deviationColours";
import { lengthFigures, roundEnd, signedLength } from "../../controls/lengths";
import legend from "../../flow/ResidualLegend.module.css";
import { signedQuantity } from "../../messages/text";
import { placeLabels } from "../../object/labelPlaces";
import { t } from "../../state/language";
import { GaugeDrawing } from "../plan/GaugeDrawing";
import styles from "./TouchView.module.css";

interface TouchViewProps {
  picture: { shape: "plane" | "sphere" | null; radius_mm: number | null; touches: TouchLine[] };
}

/** The contact points on the gauge from above, and the distance of each from it. */
export function TouchView({ picture }: TouchViewProps) {
  const placed = picture.touches.filter((touch) => touch.x_mm !== null);
  if (placed.length === 0) {
    return (
      <div className={styles.view}>
        <GaugeDrawing shape={picture.shape} touching />
        <p className={styles.words}>
          {picture.touches.length === 0
            ? t("ui-touch-dots-any-order")
            : t("ui-taken-after-few-more-they-drawn", { n: picture.touches.length })}
        </p>
      </div>
    );
  }
  return (
    <Plot
      {...picture}
      placed={placed.map((touch, i) => ({ ...touch, number: i + 1, at: [touch.x_mm ?? 0, -(touch.y_mm ?? 0)] }))}
    />
  );
}

const LABEL_PX = { wide: 82, tall: 17, text: 13, dot: 7 };

interface PlotProps {
  radius_mm: number | null;
  placed: (TouchLine & { number: number; at: [number, number] })[];
}

/** The gauge in millimetres; dots and labels in screen pixels, whatever its size. */
function Plot({ radius_mm, placed }: PlotProps) {
  const { ref: plot, width, height } = useElementSize();
  const agreeing = placed.filter((touch) => !touch.is_outlier);
  const worst = Math.max(...agreeing.map(({ residual_um }) => Math.abs(residual_um ?? 0)));
  const end = roundEnd(worst, "µm", 5, 1000);
  const reach = radius_mm ?? Math.max(...placed.flatMap(({ at }) => at.map(Math.abs)));
  const half = 1.3 * reach;
  const px = (2 * half) / (Math.min(width, height) || 400);
  const dot = LABEL_PX.dot * px;
  const places = placed.map(({ at }) => at);
  const room = { wide: LABEL_PX.wide * px, tall: LABEL_PX.tall * px, apart: 1.5 * dot };
  const [right, bottom] = [(px * width) / 2, (px * height) / 2];
  const labels = placeLabels(places, places, { ...room, bounds: [-right, -bottom, right, bottom] });
  return (
    <div className={styles.view}>
      <svg
        ref={plot}
        className={styles.plot}
        viewBox={`${-half} ${-half} ${2 * half} ${2 * half}`}
        role="img"
        aria-label={t("ui-contact-points-from-above")}
      >
        {radius_mm !== null ? (
          <circle r={radius_mm} className={styles.gauge} />
        ) : (
          <rect
            x={-1.15 * reach}
            y={-1.15 * reach}
            width={2.3 * reach}
            height={2.3 * reach}
            rx={dot}
            className={styles.gauge}
          />
        )}
        {placed.map(({ index, number, at, residual_um, is_outlier }, i) => (
          <g key={index} transform={`translate(${at.join(" ")})`}>
            {is_outlier ? (
              <path d="M0-1.5 1.5 0 0 1.5-1.5 0Z" transform={`scale(${dot})`} className={styles.outlier} />
            ) : (
              <circle r={dot} style={{ fill: deviationColour((residual_um ?? 0) / end) }} className={styles.dot} />
            )}
            <text
              x={labels[i]?.dx}
              y={(labels[i]?.dy ?? 0) + 0.35 * LABEL_PX.text * px}
              fontSize={LABEL_PX.text * px}
              textAnchor={labels[i]?.anchor}
              className={styles.label}
            >
              {number}: {signedLength(residual_um ?? 0, "µm")}
            </text>
          </g>
        ))}
      </svg>
      <div className={legend.legend}>
        <span>−{lengthFigures(end, "µm")}</span>
        <span className={legend.ramp} style={{ background: DEVIATION_CSS }} />
        <span className={styles.meaning}>
          {t("ui-off-best-fitting-gauge-outward-positive", { end: signedQuantity(end, "µm") })}
        </span>
      </div>
    </div>
  );
}
