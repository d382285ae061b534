import type { ReactNode } from "react";
import { measured } from "../controls/lengths";
import { decimalsOf } from "./answers";
import styles from "./Plot.module.css";

export const WIDTH = 1000;
export const HEIGHT = 160;
const EDGE = 10;

export interface Range {
  from: number;
  to: number;
  low: number;
  high: number;
}

/** From values to places in a plot. */
export interface Scale {
  x: (value: number) => number;
  y: (value: number) => number;
}

/** What values cover, of both axes; `also` is on the vertical one, too. */
export function rangeOf(points: { x: number; y: number }[], also: number[] = []): Range {
  const heights = [...points.map(({ y }) => y), ...also];
  const along = points.map(({ x }) => x);
  return {
    from: Math.min(...along),
    to: Math.max(...along),
    low: Math.min(...heights),
    high: Math.max(...heights),
  };
}

/** A plot as wide as its place, with the ends of both axes in words. */
export function Plot({
  range,
  unit,
  ends,
  label,
  children,
}: {
  range: Range;
  unit: string;
  ends: [ReactNode, ReactNode, ReactNode?];
  label: string;
  children: (scale: Scale) => ReactNode;
}) {
  const margin = 0.08 * Math.max(range.high - range.low, 1e-9);
  const low = range.low - margin;
  const high = range.high + margin;
  const scale: Scale = {
    x: (value) => EDGE + ((WIDTH - 2 * EDGE) * (value - range.from)) / Math.max(range.to - range.from, 1e-9),
    y: (value) => HEIGHT - (HEIGHT * (value - low)) / (high - low),
  };
  const decimals = decimalsOf(unit);
  return (
    <figure className={styles.plot}>
      <div className={styles.scale} aria-hidden="true">
        <span>{measured(high, unit, decimals)}</span>
        <span>{measured(low, unit, decimals)}</span>
      </div>
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} preserveAspectRatio="none" role="img" aria-label={label}>
        {children(scale)}
      </svg>
      <figcaption className={styles.ends}>
        <span>{ends[0]}</span>
        {ends[2] && <span>{ends[2]}</span>}
        <span>{ends[1]}</span>
      </figcaption>
    </figure>
  );
}

/** A round dot, however the plot is stretched; `quality` colours it. */
export function Dot({ x, y, title, quality, newest }: { x: number; y: number; title: string } & DotLook) {
  return (
    <path className={styles.dot} data-quality={quality} data-newest={newest || undefined} d={`M ${x} ${y} h 0`}>
      <title>{title}</title>
    </path>
  );
}

interface DotLook {
  quality?: string | undefined;
  newest?: boolean;
}
