import { useElementSize } from "@mantine/hooks";

import { measured, typed, unitOf } from "../controls/lengths";
import { t } from "../state/language";
import styles from "./FlatDrawing.module.css";

/** A gauge or a sensor, as its numbers say. */
export type FlatShape =
  | { kind: "lengths"; spheres: boolean; lengths_mm: number[]; diameter_mm: number | null }
  | { kind: "sphere"; diameter_mm: number }
  | { kind: "plate"; width_mm: number }
  | SensorShape;

interface SensorShape {
  kind: "sensor";
  width_px: number;
  height_px: number;
  stripe_axis: "u" | "v";
  laser: "red" | "green" | "blue";
  /** At the stand-off; null as long as it is not known. */
  field: { width_mm: number; height_mm: number; standoff_mm: number } | null;
}

const MARGIN_PX = 56;
const ROW_PX = 96;
const MOST_ROWS = 8;
const LEAST_RADIUS_PX = 5;

/** In one plane, with its dimensions. */
export function FlatDrawing({ shape, label }: { shape: FlatShape; label: string }) {
  const { ref, width, height } = useElementSize<HTMLDivElement>();
  return (
    <div ref={ref} className={styles.drawing}>
      {width > 0 && height > 0 && (
        <svg width={width} height={height} role="img" aria-label={label}>
          <Drawn shape={shape} width={width} height={height} />
        </svg>
      )}
    </div>
  );
}

interface Sized<Shape> {
  shape: Shape;
  width: number;
  height: number;
}

function Drawn({ shape, width, height }: Sized<FlatShape>) {
  if (shape.kind === "lengths") return <Lengths shape={shape} width={width} height={height} />;
  if (shape.kind === "sensor") return <Picture shape={shape} width={width} height={height} />;
  const side = Math.min(width, height) - 3 * MARGIN_PX;
  const [x, y] = [width / 2, height / 2];
  if (shape.kind === "sphere") {
    return (
      <>
        <circle cx={x} cy={y} r={side / 2} className={styles.body} />
        <Dimension from={x - side / 2} to={x + side / 2} y={y} words={`Ø ${exactly(shape.diameter_mm)}`} />
      </>
    );
  }
  return (
    <>
      <rect x={x - side / 2} y={y - side / 2} width={side} height={side} rx={3} className={styles.body} />
      <Dimension from={x - side / 2} to={x + side / 2} y={y + side / 2 + 28} words={exactly(shape.width_mm)} />
    </>
  );
}

/** Each length from its first sphere or face to its other one, all to one scale. */
function Lengths({ shape, width, height }: Sized<Extract<FlatShape, { kind: "lengths" }>>) {
  const { lengths_mm, spheres, diameter_mm } = shape;
  const shown = lengths_mm.slice(0, MOST_ROWS);
  const scale = (width - 3 * MARGIN_PX) / Math.max(...shown);
  const row = Math.min(ROW_PX, (height - MARGIN_PX) / shown.length);
  const radius = Math.min(row / 4, Math.max(LEAST_RADIUS_PX, ((diameter_mm ?? 0) / 2) * scale));
  const left = 1.5 * MARGIN_PX;
  const top = (height - row * shown.length) / 2;
  return shown.map((length_mm, i) => {
    const [to, y] = [left + length_mm * scale, top + (i + 0.65) * row];
    return (
      <g key={i}>
        {spheres ? (
          <>
            <path d={`M${left} ${y}H${to}`} className={styles.rod} />
            <circle cx={left} cy={y} r={radius} className={styles.body} />
            <circle cx={to} cy={y} r={radius} className={styles.body} />
          </>
        ) : (
          <rect x={left} y={y - row / 8} width={Math.max(1, to - left)} height={row / 4} className={styles.body} />
        )}
        <Dimension from={left} to={to} y={y - row / 3} words={exactly(length_mm)} />
      </g>
    );
  });
}

/** The sensor's picture with the laser line over a step, and what it covers at the stand-off. */
function Picture({ shape, width, height }: Sized<SensorShape>) {
  const { width_px, height_px, stripe_axis, field, laser } = shape;
  const scale = Math.min((width - 4 * MARGIN_PX) / width_px, (height - 4 * MARGIN_PX) / height_px);
  const [w, h] = [width_px * scale, height_px * scale];
  const [x, y] = [(width - w) / 2, (height - h) / 2];
  const line =
    stripe_axis === "u"
      ? `M${x} ${y + 0.62 * h}h${0.35 * w}v${-0.24 * h}h${0.3 * w}v${0.24 * h}h${0.35 * w}`
      : `M${x + 0.38 * w} ${y}v${0.35 * h}h${0.24 * w}v${0.3 * h}h${-0.24 * w}v${0.35 * h}`;
  return (
    <>
      <rect x={x} y={y} width={w} height={h} className={styles.picture} />
      <path d={line} className={styles.line} data-laser={laser} />
      <text x={width / 2} y={y - 14} className={styles.words}>
        {t("ui-pixels-by-pixels", { width: width_px, height: height_px })}
      </text>
      {field && (
        <text x={width / 2} y={y + h + 28} className={styles.words}>
          {t("ui-field-at-the-stand-off", {
            width: measured(field.width_mm, "mm", 1),
            height: measured(field.height_mm, "mm", 1),
            standoff: measured(field.standoff_mm, "mm", 1),
          })}
        </text>
      )}
    </>
  );
}

/** A line between two ticks with its length. */
function Dimension({ from, to, y, words }: { from: number; to: number; y: number; words: string }) {
  return (
    <>
      <path d={`M${from} ${y - 6}v12M${from} ${y}H${to}M${to} ${y - 6}v12`} className={styles.dimension} />
      <text x={(from + to) / 2} y={y - 8} className={styles.words}>
        {words}
      </text>
    </>
  );
}

/** With all the figures that were entered. */
const exactly = (value_mm: number) => `${typed(value_mm, "mm")}\u00a0${unitOf("mm")}`;
