import { beforeEach, expect, test } from "vitest";

import { go, PAGES, pathOf, TITLES } from "./router";

beforeEach(() => window.history.replaceState(null, "", "/"));

test("a page has an address, and a detail of it too", () => {
  expect([pathOf("home"), pathOf("scan"), pathOf("records", "calibration/a b")]).toEqual([
    "/",
    "/scan",
    "/records/calibration/a%20b",
  ]);
  expect(Object.keys(TITLES)).toEqual([...PAGES, "docs"]);
});

test("going somewhere makes one entry of the history", () => {
  const entries = window.history.length;
  go("records", "calibration/1");
  go("records", "calibration/1");
  expect(window.location.pathname).toBe("/records/calibration/1");
  expect(window.history.length - entries).toBeLessThanOrEqual(1);
  go("home");
  expect(window.location.pathname).toBe("/");
});
