import { expect, test } from "vitest";

import { reachesOf } from "./reaches";

test("no mark covers the middle of another, and a lonely one is easily pressed", () => {
  const places: [number, number][] = [
    [0, 0],
    [3, 4],
    [100, 0],
  ];
  expect(reachesOf(places, 22)).toEqual([2.5, 2.5, 22]);
});

test("marks in one place are as easily pressed as one", () => {
  expect(
    reachesOf(
      [
        [1, 1],
        [1, 1],
      ],
      22,
    ),
  ).toEqual([22, 22]);
});
