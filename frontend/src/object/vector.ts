import type { Vec3 } from "../api/types";

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function along(start: Vec3, direction: Vec3, length: number): Vec3 {
  return [start[0] + direction[0] * length, start[1] + direction[1] * length, start[2] + direction[2] * length];
}
