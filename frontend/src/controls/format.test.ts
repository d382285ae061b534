import { afterEach, expect, test } from "vitest";

import { chooseLanguage } from "../state/language";
import { age, days, daysAgo, duration, moment } from "./format";

afterEach(() => chooseLanguage("en"));

test("ages become coarser as they grow", () => {
  expect([0.123, 5.67, 59, 177, 1000, 8000].map(age)).toEqual([
    "0.12\u00a0s",
    "5.7\u00a0s",
    "59\u00a0s",
    "2\u00a0min\u00a057\u00a0s",
    "17\u00a0min",
    "2\u00a0h",
  ]);
  expect([0.01, 0.5, 1, 3.2].map(days)).toEqual(["14\u00a0min", "12 hours", "1 day", "3 days"]);
});

test("ages are of the language", async () => {
  await chooseLanguage("de");
  expect([0.02, 1 / 24, 1, 3].map(daysAgo)).toEqual(["vor 28\u00a0min", "vor 1 Stunde", "vor 1 Tag", "vor 3 Tagen"]);
  expect(age(0.123)).toBe("0,12\u00a0s");
});

test("moments are of the browser's own zone, and what is none stays", () => {
  const at = new Date(2026, 0, 5, 7, 8);
  expect(moment(at.toISOString())).toBe("2026-01-05 07:08");
  expect(moment("someday")).toBe("someday");
  expect([5.9, 65, 120, 3605, 7512].map(duration)).toEqual([
    "5\u00a0s",
    "1\u00a0min\u00a05\u00a0s",
    "2\u00a0min",
    "1\u00a0h",
    "2\u00a0h\u00a05\u00a0min",
  ]);
});
