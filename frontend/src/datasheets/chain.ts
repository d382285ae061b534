/** Where the joints of an arm are, from its Denavit-Hartenberg table; as app/crenel/metrology/arm/kinematics.py. */

import type { Vec3 } from "../api/types";
import { along, dot } from "../object/vector";

type Plain = Record<string, unknown>;

export interface ChainJoint {
  name: string;
  at: Vec3;
  axis: Vec3;
}

export interface Chain {
  joints: ChainJoint[];
  /** The corners of the links, from the base to the flange. */
  path: Vec3[];
  /** Centre of the tip's sphere; null without a tip. */
  tip: Vec3 | null;
}

/** Beyond it, in mm or degrees, nothing is drawn: nothing would be seen. */
const FARTHEST = 1e7;

/** A frame: its axes and its origin. */
interface Frame {
  x: Vec3;
  y: Vec3;
  z: Vec3;
  at: Vec3;
}

/**
 * The chain of a document, up to the first row that is not complete; null of a robot without a tip.
 *
 * `q_deg` are the angles of the joints as the arm reports them; null stands for 0°, or the limit that is next to it.
 */
export function chainOf(document: Plain, q_deg: readonly number[] | null): Chain | null {
  const parts = Array.isArray(document.joints) ? (document.joints as Plain[]) : [];
  const tip = numbers(document.tip, ["x_mm", "y_mm", "z_mm"]);
  if (parts.length === 0 && !tip) return null;
  const isModified = document.convention === "dh-modified";
  let frame: Frame = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], at: [0, 0, 0] };
  frame = moved(frame, document.base);
  const path = [frame.at];
  const joints: ChainJoint[] = [];
  for (const [row, part] of parts.entries()) {
    const link = numbers(part, ["a_mm", "alpha_deg", "d_mm", "theta_deg"]);
    if (!link) return { joints, path, tip: null };
    const [a = 0, alpha = 0, d = 0, theta = 0] = link;
    const turn = (Number(part.sign ?? 1) * (q_deg?.[row] ?? resting(part.limits_deg)) || 0) + theta;
    if (isModified) {
      frame = shifted(turnedX(frame, alpha), "x", a);
      path.push(frame.at);
    }
    joints.push({ name: String(part.name ?? ""), at: frame.at, axis: frame.z });
    frame = shifted(turnedZ(frame, turn), "z", d);
    path.push(frame.at);
    if (!isModified) {
      frame = turnedX(shifted(frame, "x", a), alpha);
      path.push(frame.at);
    }
    frame = moved(frame, part.error);
  }
  const [x = 0, y = 0, z = 0] = tip ?? [];
  const at = along(along(along(frame.at, frame.x, x), frame.y, y), frame.z, z);
  return { joints, path, tip: tip ? at : null };
}

/** A box along the axes. */
export interface Box {
  low: Vec3;
  high: Vec3;
}

/** The box about a chain, and about another box. */
export function boxOf({ path, tip }: Chain, other: Box | null): Box {
  const points = [...path, ...(tip ? [tip] : []), ...(other ? [other.low, other.high] : [])];
  const end = (most: typeof Math.max): Vec3 => [
    most(...points.map(([x]) => x)),
    most(...points.map(([, y]) => y)),
    most(...points.map(([, , z]) => z)),
  ];
  return { low: end(Math.min), high: end(Math.max) };
}

function numbers(part: unknown, keys: string[]): number[] | null {
  const values = keys.map((key) => (part as Plain | undefined)?.[key]);
  const isPlace = (value: unknown): value is number => typeof value === "number" && Math.abs(value) <= FARTHEST;
  return values.every(isPlace) ? values : null;
}

/** The angle nearest to 0° that a joint reaches. */
function resting(limits: unknown): number {
  const [low, high] = Array.isArray(limits) ? limits.map(Number) : [];
  return Math.max(low || 0, Math.min(high ?? 0, 0)) || 0;
}

function shifted(frame: Frame, axis: "x" | "y" | "z", by_mm: number): Frame {
  return { ...frame, at: along(frame.at, frame[axis], by_mm) };
}

/** One axis turned towards the other. */
function turned(one: Vec3, other: Vec3, by_deg: number): Vec3 {
  const angle = (by_deg * Math.PI) / 180;
  const sum = along([0, 0, 0], one, Math.cos(angle));
  return along(sum, other, Math.sin(angle));
}

const turnedZ = (f: Frame, deg: number): Frame => ({ ...f, x: turned(f.x, f.y, deg), y: turned(f.y, f.x, -deg) });
const turnedX = (f: Frame, deg: number): Frame => ({ ...f, y: turned(f.y, f.z, deg), z: turned(f.z, f.y, -deg) });
const turnedY = (f: Frame, deg: number): Frame => ({ ...f, z: turned(f.z, f.x, deg), x: turned(f.x, f.z, -deg) });

/** The frame behind an error transform or the base's: T(x, y, z) Rz Ry Rx. */
function moved(frame: Frame, part: unknown): Frame {
  const of = (key: string) => Number((part as Plain | undefined)?.[key] ?? 0) || 0;
  const at = shifted(shifted(shifted(frame, "x", of("x_mm")), "y", of("y_mm")), "z", of("z_mm"));
  return turnedX(turnedY(turnedZ(at, of("rz_deg")), of("ry_deg")), of("rx_deg"));
}

/** Of points in the order in which they are drawn: the farthest first. */
export const farthestFirst = (to: Vec3) => (a: { at: Vec3 }, b: { at: Vec3 }) => dot(to, a.at) - dot(to, b.at);
