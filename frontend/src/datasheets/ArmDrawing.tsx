import { useElementSize } from "@mantine/hooks";
import { type PointerEvent, type ReactNode, useState } from "react";

import type { Vec3 } from "../api/types";
import { along, dot } from "../object/vector";
import { type Heading, lookFrom, project, type View } from "../object/view";
import { isolated } from "../state/isolated";
import styles from "./ArmDrawing.module.css";
import { type Box, type Chain, type ChainJoint, farthestFirst } from "./chain";

/** Thickness of the links, of that to the tip, and of the joints, and the size of the base. */
const LINK_PX = 11;
const TIP_LINK_PX = 6;
const JOINT_PX = 9;
const BASE_PX = 30;
const MARGIN_PX = 44;
const LEAST_MM = 20;
/** Joints that are nearer to each other have one label. */
const APART_PX = 14;
const CIRCLE = 24;
const DEG_PER_PX = 0.4;
const STEEPEST_DEG = 89;
const FIRST = { azimuth_deg: -32, elevation_deg: 22 };

interface ArmDrawingProps {
  chain: Chain;
  /** What the drawing has room for. */
  room: Box;
  label: string;
}

/** The chain of an arm in parallel projection; dragging turns it. */
export function ArmDrawing({ chain, room, label }: ArmDrawingProps) {
  const { ref, width, height } = useElementSize<HTMLDivElement>();
  const [heading, setHeading] = useState(FIRST);
  const drag = ({ buttons, movementX, movementY }: PointerEvent) => {
    if (!buttons) return;
    setHeading(({ azimuth_deg, elevation_deg }) => ({
      azimuth_deg: azimuth_deg - movementX * DEG_PER_PX,
      elevation_deg: Math.max(-STEEPEST_DEG, Math.min(STEEPEST_DEG, elevation_deg + movementY * DEG_PER_PX)),
    }));
  };
  const view = viewOf(room, heading, width, height);
  return (
    <div ref={ref} className={styles.drawing} onPointerMove={drag}>
      {width > 0 && height > 0 && (
        <svg width={width} height={height} role="img" aria-label={label}>
          <path d={circle(view, [0, 0, 0], [0, 0, 1], BASE_PX / view.scale)} className={styles.base} />
          {partsOf(chain, view)
            .sort(farthestFirst(view.to))
            .map(({ key, drawing }) => (
              <g key={key}>{drawing}</g>
            ))}
          {labelsOf(chain.joints, view).map(({ words, x, y }) => (
            <text key={words} x={x + JOINT_PX + 5} y={y - JOINT_PX} className={styles.name}>
              {isolated(words)}
            </text>
          ))}
        </svg>
      )}
    </div>
  );
}

interface Part {
  key: string;
  at: Vec3;
  drawing: ReactNode;
}

/** Links, joints and tip, each with its middle. */
function partsOf({ path, joints, tip }: Chain, view: View): Part[] {
  const radius_mm = JOINT_PX / view.scale;
  const corners = tip ? [...path, tip] : path;
  const links = corners.slice(1).map((to, i): Part => {
    const from = corners[i] ?? to;
    const line = `M${project(view, from).join(" ")}L${project(view, to).join(" ")}`;
    const width = i === path.length - 1 ? TIP_LINK_PX : LINK_PX;
    const drawing = (
      <>
        <path d={line} className={styles.edge} strokeWidth={width + 2.5} />
        <path d={line} className={styles.link} strokeWidth={width} />
      </>
    );
    return { key: `link ${i}`, at: middle(from, to), drawing };
  });
  const turning = joints.map((joint) => ({
    key: joint.name,
    at: joint.at,
    drawing: <Cylinder joint={joint} radius_mm={radius_mm} view={view} />,
  }));
  if (!tip) return [...links, ...turning];
  const [cx, cy] = project(view, tip);
  const ball = { key: "tip", at: tip, drawing: <circle cx={cx} cy={cy} r={TIP_LINK_PX} className={styles.tip} /> };
  return [...links, ...turning, ball];
}

/** A joint about its axis. */
function Cylinder({ joint: { at, axis }, radius_mm, view }: { joint: ChainJoint; radius_mm: number; view: View }) {
  const towards = dot(view.to, axis) < 0 ? -1 : 1;
  const [near, far] = [along(at, axis, towards * radius_mm), along(at, axis, -towards * radius_mm)];
  const body = [near, far].map((end) => project(view, end).join(" ")).join("L");
  return (
    <>
      <path d={circle(view, far, axis, radius_mm)} className={styles.side} />
      <path d={`M${body}`} className={styles.body} strokeWidth={2 * radius_mm * view.scale} />
      <path d={circle(view, near, axis, radius_mm)} className={styles.end} />
    </>
  );
}

/** The names of the joints; of those at one place on the screen, together. */
function labelsOf(joints: ChainJoint[], view: View): { words: string; x: number; y: number }[] {
  const labels: { words: string; x: number; y: number }[] = [];
  for (const { name, at } of joints) {
    const [x, y] = project(view, at);
    const near = labels.find((one) => Math.hypot(one.x - x, one.y - y) < APART_PX);
    if (near) near.words += `, ${name}`;
    else labels.push({ words: name, x, y });
  }
  return labels;
}

/** The view in which a box fits. */
function viewOf({ low, high }: Box, heading: Heading, width: number, height: number): View {
  const axes = lookFrom(heading);
  const half: Vec3 = [(high[0] - low[0]) / 2, (high[1] - low[1]) / 2, (high[2] - low[2]) / 2];
  const reach = (axis: Vec3) =>
    Math.max(LEAST_MM, dot(half, [Math.abs(axis[0]), Math.abs(axis[1]), Math.abs(axis[2])]));
  const scale = Math.min((width / 2 - MARGIN_PX) / reach(axes.right), (height / 2 - MARGIN_PX) / reach(axes.up));
  return { ...axes, scale: Math.max(scale, 1e-6), centre: middle(low, high), width, height };
}

const middle = (a: Vec3, b: Vec3): Vec3 => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];

/** A circle about an axis, as an outline on the screen. */
function circle(view: View, at: Vec3, axis: Vec3, radius_mm: number): string {
  const least = axis.map(Math.abs).indexOf(Math.min(...axis.map(Math.abs)));
  const other: Vec3 = [Number(least === 0), Number(least === 1), Number(least === 2)];
  const one = unit(cross(axis, other));
  const two = cross(axis, one);
  const points = Array.from({ length: CIRCLE }, (_, i) => {
    const angle = (2 * Math.PI * i) / CIRCLE;
    const point = along(along(at, one, radius_mm * Math.cos(angle)), two, radius_mm * Math.sin(angle));
    return project(view, point)
      .map((px) => px.toFixed(1))
      .join(" ");
  });
  return `M${points.join("L")}Z`;
}

const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

const unit = (a: Vec3): Vec3 => along([0, 0, 0], a, 1 / Math.hypot(...a));
