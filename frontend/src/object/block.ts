import type { Vec3 } from "../api/types";
import type { BlockGeometry } from "../api/wire";
import { along, dot } from "./vector";

/** One flat part of the block's surface. */
export interface Patch {
  id: string;
  /** The face that the operator touches, or null for a wall inside a groove. */
  face: string | null;
  normal: Vec3;
  outline: Vec3[];
}

interface Box {
  low: Vec3;
  high: Vec3;
}

export const NORMALS: Record<string, Vec3> = {
  crest: [0, 0, 1],
  floor: [0, 0, 1],
  front: [0, -1, 0],
  back: [0, 1, 0],
  left: [-1, 0, 0],
  right: [1, 0, 0],
};

function edge(block: BlockGeometry, i: number): number {
  return block.edges_x_mm[i] ?? 0;
}

function merlons(block: BlockGeometry): { left: number; right: number }[] {
  return Array.from({ length: Math.floor(block.edges_x_mm.length / 2) }, (_, i) => ({
    left: edge(block, 2 * i),
    right: edge(block, 2 * i + 1),
  }));
}

function level(block: BlockGeometry, left: number, right: number, z: number): Vec3[] {
  const { front_y_mm: front, back_y_mm: back } = block;
  return [
    [left, front, z],
    [right, front, z],
    [right, back, z],
    [left, back, z],
  ];
}

function wall(block: BlockGeometry, x: number, foot: number): Vec3[] {
  const { front_y_mm: front, back_y_mm: back, crest_z_mm: crest } = block;
  return [
    [x, front, foot],
    [x, back, foot],
    [x, back, crest],
    [x, front, crest],
  ];
}

/** The shadow of the block: its base, slightly enlarged. */
export function footprint(block: BlockGeometry): Vec3[] {
  const [x, y] = middle(block);
  const outline = level(block, edge(block, 0), edge(block, block.edges_x_mm.length - 1), block.base_z_mm);
  return outline.map((at): Vec3 => [x + (at[0] - x) * 1.08, y + (at[1] - y) * 1.12, at[2]]);
}

/** The comb's outline, as the front and the back show it. */
function comb(block: BlockGeometry, y: number): Vec3[] {
  const { base_z_mm: base, floor_z_mm: floor, crest_z_mm: crest } = block;
  const teeth = merlons(block);
  const outline: Vec3[] = [];
  teeth.forEach(({ left, right }, i) => {
    outline.push([left, y, i === 0 ? base : floor], [left, y, crest], [right, y, crest]);
    outline.push([right, y, i === teeth.length - 1 ? base : floor]);
  });
  return outline;
}

/**
 * The patches visible to a viewer in direction `to`, in painting order: floors, then merlons
 * from far to near, then the end and the comb face that point to the viewer.
 * Each later patch is on the viewer's side of the earlier ones, so painting order is correct
 * from every direction above the block.
 */
export function visiblePatches(block: BlockGeometry, to: Vec3): Patch[] {
  const teeth = merlons(block);
  const patches: Patch[] = [];
  for (let j = 0; j + 1 < teeth.length; j++) {
    const outline = level(block, edge(block, 2 * j + 1), edge(block, 2 * j + 2), block.floor_z_mm);
    patches.push({ id: `floor:${j}`, face: "floor", normal: [0, 0, 1], outline });
  }
  const order = teeth.map((_, i) => i);
  if (to[0] < 0) order.reverse();
  for (const i of order) patches.push(...merlonPatches(block, i, teeth.length - 1));
  patches.push(...outerPatches(block));
  return patches.filter((patch) => dot(patch.normal, to) > 1e-6);
}

function merlonPatches(block: BlockGeometry, i: number, last: number): Patch[] {
  const left = edge(block, 2 * i);
  const right = edge(block, 2 * i + 1);
  const patches: Patch[] = [];
  const foot = block.floor_z_mm;
  if (i > 0) patches.push({ id: `wall:${i}:L`, face: null, normal: [-1, 0, 0], outline: wall(block, left, foot) });
  if (i < last) patches.push({ id: `wall:${i}:R`, face: null, normal: [1, 0, 0], outline: wall(block, right, foot) });
  const outline = level(block, left, right, block.crest_z_mm);
  patches.push({ id: `crest:${i}`, face: "crest", normal: [0, 0, 1], outline });
  return patches;
}

function outerPatches(block: BlockGeometry): Patch[] {
  const first = edge(block, 0);
  const last = edge(block, block.edges_x_mm.length - 1);
  const outlines: Record<string, Vec3[]> = {
    left: wall(block, first, block.base_z_mm),
    right: wall(block, last, block.base_z_mm),
    front: comb(block, block.front_y_mm),
    back: comb(block, block.back_y_mm),
  };
  return Object.entries(outlines).map(([face, outline]) => ({
    id: face,
    face,
    normal: NORMALS[face] ?? [0, 0, 1],
    outline,
  }));
}

export function middle(block: BlockGeometry): Vec3 {
  return [
    (edge(block, 0) + edge(block, block.edges_x_mm.length - 1)) / 2,
    (block.front_y_mm + block.back_y_mm) / 2,
    (block.base_z_mm + block.crest_z_mm) / 2,
  ];
}

/** Half the block's length, depth and height. */
export function halfSize(block: BlockGeometry): Vec3 {
  const centre = middle(block);
  return [
    edge(block, block.edges_x_mm.length - 1) - centre[0],
    block.back_y_mm - centre[1],
    block.crest_z_mm - centre[2],
  ];
}

function boxes(block: BlockGeometry): Box[] {
  const { front_y_mm: front, back_y_mm: back, base_z_mm: base, floor_z_mm: floor } = block;
  const slab: Box = {
    low: [edge(block, 0), front, base],
    high: [edge(block, block.edges_x_mm.length - 1), back, floor],
  };
  const teeth = merlons(block).map(
    ({ left, right }): Box => ({ low: [left, front, floor], high: [right, back, block.crest_z_mm] }),
  );
  return [slab, ...teeth];
}

function hits(box: Box, start: Vec3, to: Vec3): boolean {
  let near = 0;
  let far = Infinity;
  for (const axis of [0, 1, 2] as const) {
    if (Math.abs(to[axis]) < 1e-9) {
      if (start[axis] <= box.low[axis] || start[axis] >= box.high[axis]) return false;
      continue;
    }
    const a = (box.low[axis] - start[axis]) / to[axis];
    const b = (box.high[axis] - start[axis]) / to[axis];
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
  }
  return far - near > 1e-6;
}

/** Whether a viewer towards `to` sees the surface at this point. */
export function isVisible(block: BlockGeometry, at: Vec3, normal: Vec3, to: Vec3): boolean {
  if (dot(normal, to) <= 0) return false;
  const lifted = along(at, normal, 0.25);
  return !boxes(block).some((box) => hits(box, lifted, to));
}
