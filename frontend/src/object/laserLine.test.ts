import { expect, test } from "vitest";

import type { BlockGeometry } from "../api/wire";
import { laserLine, visibleLine } from "./laserLine";

const BLOCK: BlockGeometry = {
  kind: "block",
  edges_x_mm: [-20, -10, 10, 20, 30, 40],
  front_y_mm: -10,
  back_y_mm: 10,
  crest_z_mm: 10,
  floor_z_mm: 0,
  base_z_mm: -10,
};

test("a merlon keeps the light from a part of the floor behind it", () => {
  const pieces = laserLine(BLOCK, 105); // the light is 100 mm above the crests
  const floors = pieces.filter(({ from, to }) => from[2] === 0 && to[2] === 0).map(({ from, to }) => [from[0], to[0]]);
  expect(floors).toEqual([
    [-10, 10],
    [22, 30],
  ]);
  const crests = pieces.filter(({ from, to }) => from[2] === 10 && to[2] === 10);
  expect(crests.map(({ from, to }) => [from[0], to[0]])).toEqual([
    [-20, -10],
    [10, 20],
    [30, 40],
  ]);
});

test("walls that look at the light are lit, down to where a merlon hides them", () => {
  const walls = (standoff_mm: number) =>
    laserLine(BLOCK, standoff_mm)
      .filter(({ normal }) => normal[0] !== 0)
      .map(({ from, normal }) => [from[0], from[2], normal[0]]);
  expect(walls(105)).toEqual([
    [10, 0, -1],
    [-10, 0, 1],
    [30, 0, -1],
  ]);
  // from 15 mm above the crests, light past the edge at 20 mm falls 7.5 mm on the way to the wall at 30 mm
  expect(walls(20).at(-1)).toEqual([30, 2.5, -1]);
});

test("only what a viewer sees is drawn", () => {
  expect(visibleLine(BLOCK, 105, [0, -1, 0])).toEqual([]);
  const lengths = visibleLine(BLOCK, 105, [0, 0, 1]).map(([from, to]) => to[0] - from[0]);
  expect(lengths.reduce((sum, length) => sum + length, 0)).toBeCloseTo(58, 5);
});
