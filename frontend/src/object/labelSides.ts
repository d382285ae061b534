export type Side = "left" | "right";

interface Spot {
  index: number;
  /** Position of the point, in the unit of the label size. */
  at: [number, number];
}

/**
 * The side of its point on which each label is, so that labels do not overlap if there is a
 * free side, and none extends beyond the edges at ``edge`` to the left and right of 0.
 */
export function labelSides(spots: Spot[], label: { wide: number; tall: number }, edge = Infinity): Map<number, Side> {
  const taken: [number, number][] = [];
  const sides = new Map<number, Side>();
  for (const { index, at } of [...spots].sort((a, b) => b.at[0] - a.at[0])) {
    const [x, y] = at;
    const within = (left: number) => left > -edge && left + label.wide < edge;
    const free = (left: number) =>
      within(left) && taken.every(([u, v]) => Math.abs(u - left) > label.wide || Math.abs(v - y) > label.tall);
    const left = !free(x) && (free(x - label.wide) || (!within(x) && within(x - label.wide)));
    const side = left ? "left" : "right";
    taken.push([side === "right" ? x : x - label.wide, y]);
    sides.set(index, side);
  }
  return sides;
}
