export type Point = readonly [number, number];

/** Where along a line its label may be, in the order of preference: at its second end first. */
const SHARES = [1, 0, 0.75, 0.25, 0.5];

interface Marked {
  line: readonly [Point, Point];
}

/** The marks with a place for the label of each: on its line, and at least `apart` from the labels before it, if there
 * is such a place. */
export function placeLabels<Mark extends Marked>(marks: readonly Mark[], apart: number): (Mark & { label: Point })[] {
  const placed: (Mark & { label: Point })[] = [];
  for (const mark of marks) {
    const options = SHARES.map((share) => along(mark.line, share));
    const free = options.find((option) => placed.every((other) => distance(option, other.label) >= apart));
    placed.push({ ...mark, label: free ?? mark.line[1] });
  }
  return placed;
}

function along([from, to]: readonly [Point, Point], share: number): Point {
  return [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
}

function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}
