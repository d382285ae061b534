import { expect, test } from "vitest";

import { frameAbout, middleOf, project } from "./projection";

test("up is up, right is right, and what is behind is higher", () => {
  const [x, y] = project([0, 0, 0]);
  expect(project([0, 0, 10])[1]).toBeLessThan(y);
  expect(project([10, 0, 0])[0]).toBeGreaterThan(x);
  expect(project([0, 10, 0])[1]).toBeLessThan(y);
});

test("the frame has all points in it, with a margin", () => {
  const frame = frameAbout(
    [
      [0, 0],
      [10, 5],
    ],
    0.1,
  );
  expect(frame).toEqual({ left: -1, top: -1, width: 12, height: 7 });
  expect(frameAbout([], 0.1).width).toBe(1);
});

test("the middle of points", () => {
  expect(
    middleOf([
      [0, 0],
      [2, 4],
    ]),
  ).toEqual([1, 2]);
});
