import { expect, test } from "vitest";

import { labelSides } from "./labelSides";

const LABEL = { wide: 4, tall: 1 };
const sides = (spots: [number, number][], edge?: number) =>
  spots.map((_, index) =>
    labelSides(
      spots.map((at, i) => ({ index: i, at })),
      LABEL,
      edge,
    ).get(index),
  );

test("labels are to the right, where they cover no other and end within the edge", () => {
  expect(
    sides([
      [0, 0],
      [0, 5],
    ]),
  ).toEqual(["right", "right"]);
  expect(
    sides([
      [0, 0],
      [1, 0.5],
    ]),
  ).toEqual(["left", "right"]);
  expect(sides([[9, 0]], 10)).toEqual(["left"]);
});
