/** A view of the part from in front, from the right and from above, as drawings show it. */
export type Point = readonly [number, number, number];
export type Flat = readonly [number, number];

const TURN = (-28 * Math.PI) / 180;
const TILT = (38 * Math.PI) / 180;

/** A point of the part frame (mm) on the picture: right and down. */
export function project([x, y, z]: Point): Flat {
  const right = x * Math.cos(TURN) - y * Math.sin(TURN);
  const away = x * Math.sin(TURN) + y * Math.cos(TURN);
  return [right, -(z * Math.cos(TILT) + away * Math.sin(TILT))];
}

export interface Frame {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** The rectangle about points of the picture, with a margin; of nothing, a square. */
export function frameAbout(points: readonly Flat[], margin: number): Frame {
  if (points.length === 0) return { left: 0, top: 0, width: 1, height: 1 };
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  const width = Math.max(Math.max(...xs) - Math.min(...xs), 1);
  const height = Math.max(Math.max(...ys) - Math.min(...ys), 1);
  const space = margin * Math.max(width, height);
  return {
    left: Math.min(...xs) - space,
    top: Math.min(...ys) - space,
    width: width + 2 * space,
    height: height + 2 * space,
  };
}

/** The middle of points of the picture. */
export function middleOf(points: readonly Flat[]): Flat {
  const sum = points.reduce(([a, b], [x, y]) => [a + x, b + y] as const, [0, 0] as const);
  const count = Math.max(points.length, 1);
  return [sum[0] / count, sum[1] / count];
}
