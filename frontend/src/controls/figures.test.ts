import { afterEach, expect, test } from "vitest";

import { chooseDecimalSign, figures, plainFigures, signed } from "./figures";

afterEach(() => chooseDecimalSign("en"));

test("thousands are grouped from five digits on, and a minus is a true one", () => {
  expect([1234, 12345, 1234567].map((value) => figures(value))).toEqual(["1234", "12\u2009345", "1\u2009234\u2009567"]);
  expect(figures(-12.345, 2)).toBe("\u221212.35");
  expect(figures(-0.004, 2)).toBe("0.00");
});

test("a sign is always there, but for nothing", () => {
  expect([0.04, -0.06, 0.001].map((value) => signed(value, 2))).toEqual(["+0.04", "\u22120.06", "0.00"]);
});

test("German has a comma, files have not", () => {
  chooseDecimalSign("de");
  expect(figures(12345.678, 2)).toBe("12\u2009345,68");
  expect(plainFigures(-12345.678, 2)).toBe("-12345.68");
  expect(plainFigures(-0.001, 2)).toBe("0.00");
  chooseDecimalSign("en");
  expect(figures(0.5, 1)).toBe("0.5");
});

test("what is no number is a dash", () => {
  expect([Number.NaN, Infinity].map((value) => figures(value, 1))).toEqual(["–", "–"]);
});
