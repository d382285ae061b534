export type Side = "left" | "right";

interface Spot {
  index: number;
  /** Where the point is, in the unit of the labels' size. */
  at: [number, number];
}

/** On which side of its point each label stands, so that no two cover each other. */
export function labelSides(spots: Spot[], label: { wide: number; tall: number }): Map<number, Side> {
  const taken: [number, number][] = [];
  const sides = new Map<number, Side>();
  for (const { index, at } of [...spots].sort((a, b) => b.at[0] - a.at[0])) {
    const [x, y] = at;
    const free = (left: number) =>
      taken.every(([u, v]) => Math.abs(u - left) > label.wide || Math.abs(v - y) > label.tall);
    const side = free(x) || !free(x - label.wide) ? "right" : "left";
    taken.push([side === "right" ? x : x - label.wide, y]);
    sides.set(index, side);
  }
  return sides;
}
