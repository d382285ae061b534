type Place = readonly [number, number];

/**
 * How far around each place a press counts as one of it: half the way to its nearest neighbour, at
 * most `most`. So no mark covers the middle of another, however close they lie. Places that are the
 * same count as one, of which the last drawn is pressed.
 */
export function reachesOf(places: readonly Place[], most: number): number[] {
  return places.map(([u, v]) => {
    const apart = places.map(([x, y]) => Math.hypot(x - u, y - v)).filter((distance) => distance > 0);
    return Math.min(most, ...apart.map((distance) => distance / 2));
  });
}
