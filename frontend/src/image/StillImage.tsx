import { useElementSize } from "@mantine/hooks";
import { type CSSProperties, useState } from "react";
import type { Vec3 } from "../api/types";
import type { ImageAnnotation, WorstPointLine } from "../api/wire";
import { measured } from "../controls/lengths";
import { reachesOf } from "../controls/reaches";
import { type PlainId, quantity } from "../messages/text";
import { placeLabels, type Spot } from "../object/labelPlaces";
import { cornerName } from "../result/names";
import { addressOf } from "../state/base";
import { t } from "../state/language";
import { COLOURS, type Overlay, type OverlayCorner, spacing_px } from "./overlay";
import styles from "./StillImage.module.css";

interface StillImageProps extends Overlay {
  image_url: string;
  width_px: number;
  height_px: number;
  /** In a refused picture: the evidence. */
  marks?: ImageAnnotation[];
  /** For a result: u, v of points of the stripe, and the deviation of each. */
  stripe_off?: Vec3[];
  /** Draws the residuals of corners and stripe as arrows, enlarged. */
  residuals?: boolean;
  /** Of the points that fit worst, those in this picture: named in place. */
  worst?: WorstPointLine[];
}

const MARKS: Record<ImageAnnotation["kind"], { colour: string; title: PlainId }> = {
  disagrees: { colour: "#ff9f43", title: "ui-misplaced-edges" },
  outside: { colour: "#d0a2ff", title: "ui-out-of-the-frame" },
  clipped: { colour: "#ff5a5f", title: "ui-overexposed" },
  outline: { colour: COLOURS.outline, title: "ui-the-closest-detection-of-the-object" },
  segment: { colour: "#9aa7b4", title: "ui-straight-edges" },
};
/** Maximum extension beyond the picture, as a share of its size, if the object extends beyond it. */
const BEYOND = 0.35;
/** A label's height on the screen, whatever the picture's size. */
const LABEL_PX = 15;
const KINDS = Object.keys(MARKS) as ImageAnnotation["kind"][];

/** Magnification of residuals (px) at which the largest is visible and covers little. */
function enlargement(residuals_px: number[], longest_px: number): number {
  const largest = Math.max(1e-6, ...residuals_px);
  return [2000, 1000, 500, 200, 100, 50, 20, 10].find((times) => largest * times <= longest_px) ?? 5;
}

/** Separate for corners and stripe: a corner is far more accurate than a point of the stripe. */
interface Enlarged {
  corners: number;
  stripe: number;
}

function enlarged(corners: OverlayCorner[], stripe_off: Vec3[], width_px: number): Enlarged {
  const longest_px = width_px / 18;
  return {
    corners: enlargement(
      corners.map((c) => c.residual_px ?? 0),
      Math.min(longest_px, 1.2 * spacing_px(corners)),
    ),
    stripe: enlargement(
      stripe_off.map((p) => Math.abs(p[2])),
      longest_px,
    ),
  };
}

/** The picture's frame, extended to parts of the object beyond it. */
function frameOf(marks: ImageAnnotation[], width_px: number, height_px: number): string {
  const beyond = marks.filter(({ kind }) => kind !== "segment" && kind !== "clipped");
  const range = (ends: number[], size: number): [number, number] => [
    Math.max(-BEYOND * size, Math.min(-0.5, ...ends)),
    Math.min((1 + BEYOND) * size, Math.max(size - 0.5, ...ends)),
  ];
  const [left, right] = range(
    beyond.flatMap(({ u0, u1 }) => [u0, u1]),
    width_px,
  );
  const [top, low] = range(
    beyond.flatMap(({ v0, v1 }) => [v0, v1]),
    height_px,
  );
  return `${left} ${top} ${right - left} ${low - top}`;
}

/** An arrow from the corner. */
function arrow(du: number, dv: number): string {
  const length = Math.hypot(du, dv);
  if (length < 1) return "";
  const head = Math.min(9, length / 2) / length;
  const [bu, bv] = [du * (1 - head), dv * (1 - head)];
  const [pu, pv] = [-dv * head * 0.5, du * head * 0.5];
  return `M0 0L${du} ${dv}M${bu + pu} ${bv + pv}L${du} ${dv}L${bu - pu} ${bv - pv}`;
}

/** Whether the stripe runs down the picture, so that it lies off to the left or right. */
function alongRows(stripe_off: Vec3[]): boolean {
  const spread = (axis: 0 | 1) =>
    Math.max(...stripe_off.map((p) => p[axis])) - Math.min(...stripe_off.map((p) => p[axis]));
  return spread(1) > spread(0);
}

function stripeArrows(stripe_off: Vec3[], times: number): string {
  const across = alongRows(stripe_off) ? "h" : "v";
  return stripe_off.map(([u, v, off]) => `M${u} ${v}${across}${off * times}`).join("");
}

/** The captured picture with its detections. */
export function StillImage(props: StillImageProps) {
  const { image_url, width_px, height_px, corners, outline, stripe, marks = [], residuals = false, worst = [] } = props;
  const stripe_off = residuals ? (props.stripe_off ?? []) : [];
  const times = residuals ? enlarged(corners, stripe_off, width_px) : null;
  const [name, setName] = useState<string | null>(null);
  const { ref, width, height } = useElementSize<HTMLDivElement>();
  const scale = Math.max(width_px / Math.max(width, 1), height_px / Math.max(height, 1));
  const corner = corners.find((c) => c.name === name);
  const apart_px = spacing_px(corners);
  const reaches = reachesOf(
    corners.map(({ u, v }) => [u, v]),
    width_px / 50,
  );
  return (
    <figure className={styles.figure}>
      <div ref={ref} className={styles.space} style={{ "--shape": `${width_px} / ${height_px}` } as CSSProperties}>
        <svg
          className={styles.picture}
          viewBox={frameOf(marks, width_px, height_px)}
          role="img"
          aria-label={t("ui-captured-picture-corners-outline-stripe")}
        >
          <image href={addressOf(image_url)} x="-0.5" y="-0.5" width={width_px} height={height_px} />
          <path
            className={styles.line}
            stroke={COLOURS.outline}
            d={outline.map(([u0, v0, u1, v1]) => `M${u0} ${v0}L${u1} ${v1}`).join("")}
          />
          <path className={styles.stripe} stroke={COLOURS.stripe} d={stripe.map(([u, v]) => `M${u} ${v}h0`).join("")} />
          <path className={styles.arrow} stroke="#ff9ea1" d={times ? stripeArrows(stripe_off, times.stripe) : ""} />
          {marks.length > 0 && <rect x="-0.5" y="-0.5" width={width_px} height={height_px} className={styles.frame} />}
          {KINDS.toReversed().map((kind) => (
            <path
              key={kind}
              className={styles.mark}
              stroke={MARKS[kind].colour}
              d={marks
                .filter((mark) => mark.kind === kind)
                .map(({ u0, v0, u1, v1 }) => `M${u0} ${v0}L${u1} ${v1}`)
                .join("")}
            />
          ))}
          {corners.map((c, i) => (
            <g key={c.name} transform={`translate(${c.u} ${c.v})`} onPointerEnter={() => setName(c.name)}>
              <circle r={reaches[i]} className={styles.reach} />
              {times && c.off_px && (
                <path
                  className={styles.arrow}
                  stroke={COLOURS.corner}
                  d={arrow(c.off_px[0] * times.corners, c.off_px[1] * times.corners)}
                />
              )}
              <circle
                r={residuals ? 2 : Math.min(width_px / 160, apart_px / 5)}
                className={styles.corner}
                stroke={COLOURS.corner}
              />
            </g>
          ))}
          <Worst
            worst={worst}
            spots={corners.map(({ u, v }) => [u, v])}
            size={LABEL_PX * scale}
            bounds={[-0.5, -0.5, width_px - 0.5, height_px - 0.5]}
          />
        </svg>
      </div>
      <figcaption className={styles.caption}>
        {corner ? (
          cornerSummary(corner.name, corner.residual_px)
        ) : marks.length ? (
          <Legend marks={marks} />
        ) : (
          summary(props, times)
        )}
      </figcaption>
    </figure>
  );
}

interface WorstProps {
  worst: WorstPointLine[];
  /** All corners of the picture. */
  spots: Spot[];
  size: number;
  bounds: [number, number, number, number];
}

/** The points with the largest residuals, each with a label, which covers no other and no corner if it can. */
function Worst({ worst, spots, size, bounds }: WorstProps) {
  const named = worst.flatMap(({ at_px, ...point }) =>
    at_px ? [{ ...point, at: [at_px[0], at_px[1]] as const }] : [],
  );
  const room = { wide: 4.6 * size, tall: 1.1 * size, apart: 0.7 * size, bounds };
  const labels = placeLabels(
    named.map(({ at }) => at),
    [...spots, ...named.map(({ at }) => at)],
    room,
  );
  return named.map(({ kind, name, value, unit, at }, i) => (
    <g key={kind + name} transform={`translate(${at[0]} ${at[1]})`} className={styles.worst}>
      {kind === "stripe" && <path d={`M0 ${-size / 2}V${size / 2}`} className={styles.tick} />}
      <text x={labels[i]?.dx} y={(labels[i]?.dy ?? 0) + 0.35 * size} fontSize={size} textAnchor={labels[i]?.anchor}>
        {measured(value, unit, unit === "px" ? 2 : 0)}
      </text>
    </g>
  ));
}

function Legend({ marks }: { marks: ImageAnnotation[] }) {
  const kinds = KINDS.filter((kind) => marks.some((mark) => mark.kind === kind));
  return kinds.map((kind) => (
    <span key={kind} className={styles.legend}>
      <i style={{ background: MARKS[kind].colour }} /> {t(MARKS[kind].title)}
    </span>
  ));
}

function cornerSummary(name: string, residual_px: number | null): string {
  const where = cornerName(name);
  return residual_px === null
    ? where
    : t("ui-corner-residual", { corner: where, value: quantity(residual_px, "px", 3) });
}

function summary({ corners, stripe }: Overlay, times: Enlarged | null): string {
  // the stripe is thinned for drawing: the number of its points would be wrong
  const text = stripe.length > 0 ? "ui-corners-and-the-laser-stripe" : "ui-corners-no-laser-stripe";
  const found = t(text, { corners: corners.length });
  return times ? `${found}. ${arrowsSummary(times)}` : found;
}

function arrowsSummary({ corners, stripe }: Enlarged): string {
  return corners === stripe
    ? t("ui-arrows-detected-minus-computed-magnified-times", { times: corners })
    : t("ui-arrows-detected-minus-computed-corners-magnified", { times: corners, stripe });
}
