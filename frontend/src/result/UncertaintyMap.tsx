import { useState } from "react";
import type { CalibrationResult } from "../api/wire";
import { lengthFigures, measured } from "../controls/lengths";
import { Segments } from "../controls/Segments";
import { quantity } from "../messages/text";
import { t } from "../state/language";
import styles from "./UncertaintyMap.module.css";

interface MapProps {
  result: CalibrationResult;
  width_px: number;
  height_px: number;
}

interface Cell {
  u: number;
  v: number;
  um: number;
  inside: boolean;
}

/** Steps of a blue scale; light means a small uncertainty. */
const SCALE = ["#d6e8fb", "#a9cff6", "#74b0ee", "#3f8be0", "#1f66bd", "#114688"];

/** The uncertainty of a scanned point, and its displacement since the last calibration, over the
 *  picture; the laser light lies in one plane only. */
export function UncertaintyMap({ result, width_px, height_px }: MapProps) {
  const [selected, setSelected] = useState("known");
  const { map, comparison } = result;
  if (map.length === 0) {
    return <p className={styles.none}>{t("ui-calibrations-older-versions-no-map")}</p>;
  }
  const inside = new Map(map.map((p) => [`${p.u} ${p.v}`, p.inside]));
  const moved = comparison?.map ?? [];
  const change = selected === "moved" && comparison && moved.length > 0;
  return (
    <div className={styles.view}>
      {moved.length > 0 && (
        <div className={styles.choice}>
          <Segments
            value={selected}
            onChange={setSelected}
            options={[
              { value: "known", label: t("ui-uncertainty") },
              { value: "moved", label: t("ui-change") },
            ]}
            label={t("ui-plotted-quantity")}
          />
        </div>
      )}
      <Field
        cells={
          change
            ? moved.map((p) => ({ ...p, um: p.moved_um, inside: inside.get(`${p.u} ${p.v}`) ?? true }))
            : map.map((p) => ({ ...p, um: p.u_um }))
        }
        words={
          change
            ? t("ui-displacement-scanned-point-since-rms-most", {
                name: comparison.with_name,
                rms: quantity(comparison.rms_um, "µm"),
                most: quantity(comparison.max_um, "µm"),
              })
            : t("ui-standard-uncertainty-over-picture")
        }
        width_px={width_px}
        height_px={height_px}
      />
    </div>
  );
}

interface FieldProps {
  cells: Cell[];
  words: string;
  width_px: number;
  height_px: number;
}

function Field({ cells, words, width_px, height_px }: FieldProps) {
  const inside = cells.filter((cell) => cell.inside).map((cell) => cell.um);
  const all = cells.map((cell) => cell.um);
  const low = Math.min(...(inside.length > 0 ? inside : all));
  const high = Math.max(low * 1.02, ...all);
  const colour = (value: number) =>
    SCALE[Math.min(SCALE.length - 1, Math.max(0, Math.floor(((value - low) / (high - low || 1)) * SCALE.length)))];
  const wide = step(cells.map((cell) => cell.u));
  const tall = step(cells.map((cell) => cell.v));
  const bare =
    Math.max(...cells.map((cell) => cell.v)) + tall / 2 < height_px ||
    Math.min(...cells.map((cell) => cell.v)) - tall / 2 > 0;
  const worst = cells.reduce((a, b) => (b.inside && (!a.inside || b.um > a.um) ? b : a));
  return (
    <figure className={styles.map}>
      <svg
        className={styles.picture}
        viewBox={`0 0 ${width_px} ${height_px}`}
        role="img"
        aria-label={`${words} ${t("ui-range", { low: lengthFigures(low, "µm"), high: quantity(high, "µm") })}`}
      >
        <defs>
          <pattern id="extrapolated" width="14" height="14" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
            <line x1="0" y1="0" x2="0" y2="14" className={styles.hatch} />
          </pattern>
        </defs>
        <clipPath id="frame">
          <rect width={width_px} height={height_px} />
        </clipPath>
        <rect width={width_px} height={height_px} className={styles.empty} />
        <g clipPath="url(#frame)" shapeRendering="crispEdges">
          {cells.map(({ u, v, um, inside: covered }) => (
            <g key={`${u} ${v}`}>
              <rect x={u - wide / 2} y={v - tall / 2} width={wide + 1} height={tall + 1} fill={colour(um)}>
                <title>
                  {t("ui-value-at-pixel", { value: quantity(um, "µm", 1), u: quantity(u), v: quantity(v, "px") })}
                </title>
              </rect>
              {!covered && (
                <rect x={u - wide / 2} y={v - tall / 2} width={wide + 1} height={tall + 1} fill="url(#extrapolated)" />
              )}
            </g>
          ))}
        </g>
        <text
          x={Math.min(Math.max(worst.u, 0.09 * width_px), 0.91 * width_px)}
          y={worst.v}
          className={styles.worst}
          fontSize={width_px / 28}
        >
          {measured(worst.um, "µm", 1)}
        </text>
      </svg>
      <figcaption className={styles.legend}>
        <span>{measured(low, "µm", 1)}</span>
        <span className={styles.scale}>
          {SCALE.map((one) => (
            <span key={one} style={{ background: one }} />
          ))}
        </span>
        <span>{measured(high, "µm", 1)}</span>
        <span className={styles.words}>
          {words} {t("ui-hatched-beyond-depths-stripe-covered-labelled")}
          {bare && ` ${t("ui-grey-far-beyond-them-no-statement")}`}
        </span>
      </figcaption>
    </figure>
  );
}

/** The grid's step: the least distance between two different values. */
function step(values: number[]): number {
  const sorted = [...new Set(values)].sort((a, b) => a - b);
  const apart = sorted.slice(1).map((value, i) => value - (sorted[i] ?? value));
  return Math.min(...apart.filter((d) => d > 0.5), 400);
}
