import { useMemo } from "react";

import type { BlockGeometry } from "../api/wire";
import styles from "./LaserOnBlock.module.css";
import { visibleLine } from "./laserLine";
import { project, type View } from "./view";

interface LaserOnBlockProps {
  block: BlockGeometry;
  /** From the laser to half the depth of the grooves. */
  standoff_mm: number;
  view: View;
}

/** The laser line on a block under the sensor, on top of its drawing. */
export function LaserOnBlock({ block, standoff_mm, view }: LaserOnBlockProps) {
  const pieces = useMemo(() => visibleLine(block, standoff_mm, view.to), [block, standoff_mm, view.to]);
  const path = pieces
    .map(([from, to]) =>
      [from, to]
        .map((at) =>
          project(view, at)
            .map((px) => px.toFixed(2))
            .join(" "),
        )
        .join("L"),
    )
    .map((piece) => `M${piece}`)
    .join("");
  return <path d={path} className={styles.line} data-laser />;
}
