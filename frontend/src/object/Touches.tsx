import type { KeyboardEvent } from "react";

import type { BlockGeometry, TouchedPoint, Vec3 } from "../api/types";
import { signed } from "../parts/format";
import { isSeen, NORMALS } from "./block";
import { rampColour } from "./residuals";
import styles from "./Touches.module.css";
import { along } from "./vector";
import { layOn, project, type View } from "./view";

const UP: Vec3 = [0, 0, 1];

function normalOf(face: string): Vec3 {
  return NORMALS[face] ?? UP;
}

/** Rings lying on the face, where it would be good to touch. */
export function Suggestions({ view, face, places }: { view: View; face: string; places: Vec3[] }) {
  const radius_mm = 11 / view.scale;
  return (
    <g className={styles.rings} aria-hidden="true">
      {places.map((at) => (
        <g key={at.join()} transform={layOn(view, at, normalOf(face))}>
          <circle r={radius_mm} className={styles.halo} />
          <circle r={radius_mm} className={styles.ring} />
          <circle r={radius_mm * 0.16} className={styles.spot} />
        </g>
      ))}
    </g>
  );
}

interface TouchesProps {
  view: View;
  block: BlockGeometry;
  points: TouchedPoint[];
  scale_um: number;
  chosen: number | null;
  onPoint: (index: number) => void;
}

/** Touched points coloured by residual; an outlier is a diamond with its value beside it. */
export function Touches({ view, block, points, scale_um, chosen, onPoint }: TouchesProps) {
  return (
    <g>
      {points.map(
        (point) =>
          point.at_mm && (
            <Touch
              key={point.index}
              point={point}
              at={project(view, point.at_mm)}
              seen={isSeen(block, point.at_mm, normalOf(point.face), view.to)}
              scale_um={scale_um}
              chosen={point.index === chosen}
              onPoint={onPoint}
            />
          ),
      )}
    </g>
  );
}

interface TouchProps {
  point: TouchedPoint;
  at: [number, number];
  seen: boolean;
  scale_um: number;
  chosen: boolean;
  onPoint: (index: number) => void;
}

function Touch({ point, at, seen, scale_um, chosen, onPoint }: TouchProps) {
  const residual = point.residual_um;
  const words = residual === null ? "no residual yet" : `${signed(residual)} µm`;
  const fill = residual === null ? "var(--ink-3)" : rampColour(Math.abs(residual) / scale_um);
  const onKey = (event: KeyboardEvent) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    onPoint(point.index);
  };
  return (
    <g
      className={styles.touch}
      transform={`translate(${at[0]} ${at[1]})`}
      role="button"
      tabIndex={0}
      aria-label={`Point ${point.index + 1} on ${point.face}, ${words}${point.outlier ? ", outlier" : ""}`}
      data-hidden={!seen || undefined}
      data-chosen={chosen || undefined}
      onClick={() => onPoint(point.index)}
      onKeyDown={onKey}
    >
      <circle r="22" className={styles.reach} />
      {point.outlier ? (
        <path d="M0-12 12 0 0 12-12 0Z" className={styles.outlier} />
      ) : (
        <circle r="8" className={styles.point} style={{ fill: seen ? fill : "none", stroke: seen ? undefined : fill }} />
      )}
      {point.outlier && (
        <text x="18" y="6" className={styles.value}>
          {words}
        </text>
      )}
    </g>
  );
}

/** Each residual as a stick along its face's normal, enlarged so that the scale's end is 40 px. */
export function ResidualSticks({ view, points, scale_um }: { view: View; points: TouchedPoint[]; scale_um: number }) {
  const mm_per_um = 40 / view.scale / scale_um;
  return (
    <g className={styles.sticks} aria-hidden="true">
      {points.map((point) => {
        if (!point.at_mm || point.residual_um === null) return null;
        const capped = Math.max(-2 * scale_um, Math.min(2 * scale_um, point.residual_um));
        const end = project(view, along(point.at_mm, normalOf(point.face), capped * mm_per_um));
        const start = project(view, point.at_mm);
        return <path key={point.index} d={`M${start.join(" ")}L${end.join(" ")}`} />;
      })}
    </g>
  );
}
