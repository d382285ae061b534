import type { KeyboardEvent } from "react";

import type { ObjectGeometry, Vec3 } from "../api/types";
import type { TouchedPoint } from "../api/wire";
import { deviationColour } from "../controls/deviationColours";
import { signedLength } from "../controls/lengths";
import { reachesOf } from "../controls/reaches";
import { t, word } from "../state/language";
import { type LabelPlace, placeLabels } from "./labelPlaces";
import { isVisible, normalOf } from "./shape";
import styles from "./Touches.module.css";
import { along } from "./vector";
import { dotRadius, layOn, project, type View } from "./view";

type Placed = TouchedPoint & { at_mm: Vec3 };

function placed(points: TouchedPoint[]): Placed[] {
  return points.filter((point): point is Placed => point.at_mm !== null);
}

/** Rings on the face at the suggested places. */
export function Suggestions({ view, face, places }: { view: View; face: string; places: Vec3[] }) {
  const radius_mm = (1.35 * dotRadius(view)) / view.scale;
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
  object: ObjectGeometry;
  points: TouchedPoint[];
  scale_um: number;
  chosen: number | null;
  onPoint: (index: number) => void;
  /** Points with their value beside them, as for outliers. */
  named?: number[];
}

const LABEL_PX = { wide: 84, tall: 22 };

/** Between a point's edge and the ring around it when it is chosen; as far, a press is one of it. */
const FOCUS_APART_PX = 12;

/** Contact points coloured by residual; an outlier is a diamond with its value beside it. */
export function Touches({ view, object, points, scale_um, chosen, onPoint, named = [] }: TouchesProps) {
  const visible = placed(points)
    .sort((a, b) => Number(a.outlier) - Number(b.outlier))
    .filter(({ at_mm, face }) => isVisible(object, at_mm, normalOf(face), view.to));
  const labelled = visible.filter(({ index, outlier }) => outlier || named.includes(index));
  const radius = dotRadius(view);
  const places = visible.map(({ at_mm }) => project(view, at_mm));
  const labels = placeLabels(
    labelled.map(({ at_mm }) => project(view, at_mm)),
    places,
    { ...LABEL_PX, apart: 2 * radius },
  );
  const reaches = reachesOf(places, radius + FOCUS_APART_PX);
  return (
    <g>
      {visible.map((point, i) => (
        <Touch
          key={point.index}
          point={point}
          at={places[i] ?? [0, 0]}
          radius={radius}
          reach={reaches[i] ?? 0}
          scale_um={scale_um}
          chosen={point.index === chosen}
          label={labels[labelled.indexOf(point)]}
          onPoint={onPoint}
        />
      ))}
    </g>
  );
}

interface TouchProps {
  point: TouchedPoint;
  at: [number, number];
  radius: number;
  reach: number;
  scale_um: number;
  chosen: boolean;
  /** Position of its value; without one, the value is not shown. */
  label: LabelPlace | undefined;
  onPoint: (index: number) => void;
}

function Touch({ point, at, radius, reach, scale_um, chosen, label, onPoint }: TouchProps) {
  const residual = point.residual_um;
  const value = residual === null ? t("ui-no-residual-yet") : signedLength(residual, "µm");
  const fill = residual === null ? "var(--ink-3)" : deviationColour(residual / scale_um);
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
      aria-label={[
        t("ui-point-on", { n: point.index + 1, face: word(point.face) }),
        value,
        point.outlier ? t("ui-outlier") : "",
      ]
        .filter(Boolean)
        .join(", ")}
      data-chosen={chosen || undefined}
      onClick={() => onPoint(point.index)}
      onKeyDown={onKey}
    >
      <circle r={reach} className={styles.reach} />
      <circle r={radius + FOCUS_APART_PX} className={styles.focus} />
      {point.outlier ? (
        <path d="M0-1.5 1.5 0 0 1.5-1.5 0Z" transform={`scale(${radius})`} className={styles.outlier} />
      ) : (
        <circle r={radius} className={styles.point} style={{ fill }} />
      )}
      {label && (
        <text
          x={label.dx}
          y={label.dy + 6}
          textAnchor={label.anchor}
          className={styles.value}
          data-outlier={point.outlier || undefined}
        >
          {value}
        </text>
      )}
    </g>
  );
}

interface SticksProps {
  view: View;
  object: ObjectGeometry;
  points: TouchedPoint[];
  scale_um: number;
}

const STICK_PX = 40;

/** Each residual as a line along the normal of its face; the end of the scale is 40 px from the dot. */
export function ResidualSticks({ view, object, points, scale_um }: SticksProps) {
  const sticks = placed(points).filter(({ at_mm, face }) => isVisible(object, at_mm, normalOf(face), view.to));
  return (
    <g className={styles.sticks} aria-hidden="true">
      <path d={sticks.map((point) => stick(view, point, scale_um)).join("")} className={styles.halo} />
      <path d={sticks.map((point) => stick(view, point, scale_um)).join("")} className={styles.stick} />
    </g>
  );
}

function stick(view: View, point: Placed, scale_um: number): string {
  const [x, y] = project(view, point.at_mm);
  const [out_x, out_y] = project(view, along(point.at_mm, normalOf(point.face), 1));
  const length = Math.hypot(out_x - x, out_y - y) || 1;
  const share = Math.max(-2, Math.min(2, (point.residual_um ?? 0) / scale_um));
  const reach_px = share * STICK_PX + Math.sign(share) * dotRadius(view);
  const end_x = x + ((out_x - x) / length) * reach_px;
  const end_y = y + ((out_y - y) / length) * reach_px;
  return `M${x} ${y}L${end_x} ${end_y}`;
}
