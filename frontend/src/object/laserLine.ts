import type { Vec3 } from "../api/types";
import type { BlockGeometry } from "../api/wire";
import { isVisible } from "./block";

/** Pieces in which a hidden part of the line is left out. */
const PIECES = 60;
/** The line is drawn in its middle plane. */
const Y_MM = 0;

interface Piece {
  from: Vec3;
  to: Vec3;
  normal: Vec3;
}

/**
 * Where the laser plane y = 0 lights the block: its crests, and of floors and walls what no merlon keeps from the
 * light, which spreads from a point above the middle.
 *
 * @param standoff_mm from the laser to half the depth of the grooves
 */
export function laserLine(block: BlockGeometry, standoff_mm: number): Piece[] {
  const { edges_x_mm: edges, crest_z_mm: crest, floor_z_mm: floor } = block;
  const source = (crest + floor) / 2 + standoff_mm;
  const pieces: Piece[] = [];
  const level = (from: number, to: number, z: number) => {
    if (to > from) pieces.push({ from: [from, Y_MM, z], to: [to, Y_MM, z], normal: [0, 0, 1] });
  };
  /** Where light past an upper edge comes down on the floor. */
  const landing = (x: number) => (x * (source - floor)) / (source - crest);
  /** A wall that looks at the light, which comes over the other edge of the groove. */
  const wall = (x: number, over: number) => {
    const isHidden = x * over > 0 && Math.abs(landing(over)) > Math.abs(x);
    const foot = isHidden ? crest - ((x - over) * (source - crest)) / over : floor;
    pieces.push({ from: [x, Y_MM, foot], to: [x, Y_MM, crest], normal: [x > 0 ? -1 : 1, 0, 0] });
  };
  for (let i = 0; i + 1 < edges.length; i++) {
    const [left = 0, right = 0] = edges.slice(i, i + 2);
    if (i % 2 === 0) level(left, right, crest);
    else {
      level(
        Math.max(left, left > 0 ? landing(left) : left),
        Math.min(right, right < 0 ? landing(right) : right),
        floor,
      );
      if (right > 0) wall(right, left);
      if (left < 0) wall(left, right);
    }
  }
  return pieces;
}

/** The parts of it that a viewer in direction `to` sees, as short lines. */
export function visibleLine(block: BlockGeometry, standoff_mm: number, to: Vec3): [Vec3, Vec3][] {
  return laserLine(block, standoff_mm).flatMap(({ from, to: end, normal }) => {
    const at = (share: number): Vec3 => [
      from[0] + share * (end[0] - from[0]),
      from[1] + share * (end[1] - from[1]),
      from[2] + share * (end[2] - from[2]),
    ];
    const shown: [Vec3, Vec3][] = [];
    for (let i = 0; i < PIECES; i++) {
      if (isVisible(block, at((i + 0.5) / PIECES), normal, to)) shown.push([at(i / PIECES), at((i + 1) / PIECES)]);
    }
    return shown;
  });
}
