import { expect, test } from "vitest";

import { type Point, placeLabels } from "./placeLabels";

const LINE: readonly [Point, Point] = [
  [0, 0],
  [100, 0],
];

function labels(lines: (readonly [Point, Point])[]): Point[] {
  return placeLabels(
    lines.map((line) => ({ line })),
    10,
  ).map(({ label }) => label);
}

test("a label stands at the second end of its line", () => {
  expect(labels([LINE])).toEqual([[100, 0]]);
});

test("labels of lines that end together are apart", () => {
  expect(labels([LINE, LINE, LINE])).toEqual([
    [100, 0],
    [0, 0],
    [75, 0],
  ]);
});

test("a line that is seen from its end keeps its label, though another is there", () => {
  const point: readonly [Point, Point] = [
    [100, 0],
    [100, 0],
  ];
  expect(labels([LINE, point])[1]).toEqual([100, 0]);
});
