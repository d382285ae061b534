import type { ObjectGeometry, Vec3 } from "../api/types";
import * as block from "./block";
import { BOARD_FACE, boardFootprint, boardHalfSize, boardMiddle } from "./board";
import { dot } from "./vector";

const UP: Vec3 = [0, 0, 1];
const NORMALS: Record<string, Vec3> = { ...block.NORMALS, [BOARD_FACE]: UP };

/** Which way a face looks. */
export function normalOf(face: string): Vec3 {
  return NORMALS[face] ?? UP;
}

export function middle(object: ObjectGeometry): Vec3 {
  return object.kind === "block" ? block.middle(object) : boardMiddle(object);
}

/** Half the object's length, depth and height. */
export function halfSize(object: ObjectGeometry): Vec3 {
  return object.kind === "block" ? block.halfSize(object) : boardHalfSize(object);
}

/** The shadow of the object: its base, slightly enlarged. */
export function footprint(object: ObjectGeometry): Vec3[] {
  return object.kind === "block" ? block.footprint(object) : boardFootprint(object);
}

/** Whether a viewer towards `to` sees the surface at this point; nothing of a board hides another part. */
export function isVisible(object: ObjectGeometry, at: Vec3, normal: Vec3, to: Vec3): boolean {
  return object.kind === "block" ? block.isVisible(object, at, normal, to) : dot(normal, to) > 0;
}
