import type { BlockGeometry } from "../api/wire";
import { measured } from "../controls/lengths";
import { project, type View } from "../object/view";
import styles from "./Certify.module.css";
import { type Dimension, dimensionLine, drawnLength } from "./dimensions";

interface DimensionLineProps {
  block: BlockGeometry;
  dimension: Dimension;
  view: View;
}

/** The dimension that is typed, beside the block, with the length that was drawn. */
export function DimensionLine({ block, dimension, view }: DimensionLineProps) {
  const ends = dimensionLine(block, dimension).map(({ at, beside }) => ({
    at: project(view, at),
    beside: project(view, beside),
  }));
  const [first, second] = ends;
  if (!first || !second) return null;
  const [x = 0, y = 0] = [0, 1].map((i) => ((first.beside[i] ?? 0) + (second.beside[i] ?? 0)) / 2);
  const upright = Math.abs(first.beside[0] - second.beside[0]) < Math.abs(first.beside[1] - second.beside[1]);
  const path = [
    ...ends.map(({ at, beside }) => `M${at.join(" ")}L${beside.join(" ")}`),
    `M${first.beside.join(" ")}L${second.beside.join(" ")}`,
  ].join("");
  return (
    <g data-dimension>
      <path d={path} className={styles.halo} />
      <path d={path} className={styles.line} />
      {ends.map(({ beside: [cx, cy] }) => (
        <circle key={`${cx} ${cy}`} cx={cx} cy={cy} r={4} className={styles.end} />
      ))}
      <text {...(upright ? { x: x - 10, y: y + 5 } : { x, y: y - 10 })} className={styles.words} data-upright={upright}>
        {measured(drawnLength(block, dimension), "mm", 3)}
      </text>
    </g>
  );
}
