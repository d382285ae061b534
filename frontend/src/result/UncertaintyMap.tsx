import type { MapPoint } from "../api/types";
import { figures } from "../parts/format";
import styles from "./UncertaintyMap.module.css";

interface MapProps {
  points: MapPoint[];
  width_px: number;
  height_px: number;
}

/** Steps of one scale of blue, light where points are known well. */
const SCALE = ["#d6e8fb", "#a9cff6", "#74b0ee", "#3f8be0", "#1f66bd", "#114688"];

/** How well a scanned point is known, over the picture: the laser's light falls on one plane only. */
export function UncertaintyMap({ points, width_px, height_px }: MapProps) {
  if (points.length === 0) {
    return <p className={styles.none}>Calibrations of older versions carry no map.</p>;
  }
  const inside = points.filter((p) => p.inside).map((p) => p.u_um);
  const low = Math.min(...inside);
  const high = Math.max(low * 1.02, ...points.map((p) => p.u_um));
  const colour = (value: number) =>
    SCALE[Math.min(SCALE.length - 1, Math.max(0, Math.floor(((value - low) / (high - low)) * SCALE.length)))];
  const wide = step(points.map((p) => p.u));
  const tall = step(points.map((p) => p.v));
  return (
    <figure className={styles.map}>
      <svg
        className={styles.picture}
        viewBox={`0 0 ${width_px} ${height_px}`}
        role="img"
        aria-label={`Uncertainty over the picture, ${figures(low)} to ${figures(high)} micrometres`}
      >
        <defs>
          <pattern id="extrapolated" width="14" height="14" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
            <line x1="0" y1="0" x2="0" y2="14" className={styles.hatch} />
          </pattern>
        </defs>
        <rect width={width_px} height={height_px} className={styles.empty} />
        {points.map((p) => (
          <g key={`${p.u} ${p.v}`}>
            <rect x={p.u - wide / 2} y={p.v - tall / 2} width={wide + 1} height={tall + 1} fill={colour(p.u_um)}>
              <title>{`${figures(p.u_um, 1)} µm at ${figures(p.u)}, ${figures(p.v)} px`}</title>
            </rect>
            {!p.inside && (
              <rect x={p.u - wide / 2} y={p.v - tall / 2} width={wide + 1} height={tall + 1} fill="url(#extrapolated)" />
            )}
          </g>
        ))}
      </svg>
      <figcaption className={styles.legend}>
        <span>{figures(low, 1)} µm</span>
        <span className={styles.scale}>
          {SCALE.map((one) => (
            <span key={one} style={{ background: one }} />
          ))}
        </span>
        <span>{figures(high, 1)} µm</span>
        <span className={styles.words}>
          Standard uncertainty of a scanned point, k = 1, over the picture. Hatched: beyond the depths that the stripe
          covered.
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
