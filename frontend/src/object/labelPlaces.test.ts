import { expect, test } from "vitest";

import { placeLabels, type Spot } from "./labelPlaces";

const SIZE = { wide: 8, tall: 2, apart: 1 };
const RIGHT = { dx: 1, dy: 0, anchor: "start" };
const LEFT = { dx: -1, dy: 0, anchor: "end" };

interface Case {
  what: string;
  labelled: Spot[];
  others?: Spot[];
  bounds?: [number, number, number, number];
  places: object[];
}

const CASES: Case[] = [
  {
    what: "right of spots far apart",
    labelled: [
      [0, 0],
      [0, 9],
    ],
    places: [RIGHT, RIGHT],
  },
  { what: "not over another spot", labelled: [[0, 0]], others: [[5, 0.5]], places: [LEFT] },
  {
    what: "nor over another label",
    labelled: [
      [0, 0],
      [-0.5, 1.2],
    ],
    places: [RIGHT, LEFT],
  },
  { what: "not cut off", labelled: [[9, 0]], bounds: [-10, -10, 10, 10], places: [LEFT] },
  {
    what: "above, where both sides are taken",
    labelled: [[0, 0]],
    others: [
      [5, 0],
      [-5, 0],
    ],
    places: [{ dx: 0, dy: -2, anchor: "middle" }],
  },
  {
    what: "rather over a spot than cut off",
    labelled: [[0, 0]],
    others: [[5, 0]],
    bounds: [-5, -1, 20, 1],
    places: [RIGHT],
  },
];

test.each(CASES)("a label is $what", ({ labelled, others = [], bounds, places }) => {
  const room = bounds ? { ...SIZE, bounds } : SIZE;
  expect(placeLabels(labelled, [...labelled, ...others], room)).toEqual(places);
});
