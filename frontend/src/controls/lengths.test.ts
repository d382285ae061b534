import { afterEach, expect, test } from "vitest";

import { chooseUnits } from "../state/units";
import { chooseDecimalSign } from "./figures";
import {
  decimalsIn,
  fieldFigures,
  fromTyped,
  lengthFigures,
  measured,
  roundEnd,
  roundTyped,
  signedLength,
  typed,
  typedNumber,
  unitOf,
} from "./lengths";

afterEach(() => {
  chooseUnits("metric");
  chooseDecimalSign("en");
});

test("metric stays as the station has it", () => {
  expect([measured(12.4, "µm"), measured(0.5, "mm", 2), signedLength(3, "µm")]).toEqual([
    "12\u00a0µm",
    "0.50\u00a0mm",
    "+3\u00a0µm",
  ]);
  expect([measured(3.5, "″", 1), measured(7, "px"), measured(5, "")]).toEqual(["3.5″", "7\u00a0px", "5"]);
});

test("inch has the resolution of the metric figure, and is rounded once", () => {
  chooseUnits("inch");
  expect([unitOf("mm"), unitOf("µm"), unitOf("mm²"), unitOf("px")]).toEqual(["in", "µin", "in²", "px"]);
  expect(measured(44, "mm", 3)).toBe("1.73228\u00a0in");
  expect([measured(12.4, "µm"), measured(12.4, "µm", 1), measured(0.1, "µm")]).toEqual([
    "490\u00a0µin",
    "488\u00a0µin",
    "0\u00a0µin",
  ]);
  for (const value of [0.2, 4.53, 115, 432.69, 1234.567]) {
    const [exact, coarse] = [3, 0].map((decimals) =>
      Number(lengthFigures(value, "µm", decimals).replace("\u2009", "")),
    );
    expect(coarse).toBe(Math.round((exact ?? Number.NaN) / 10) * 10);
  }
  expect([decimalsIn("mm", 0), decimalsIn("mm", 3), decimalsIn("µm", 1)]).toEqual([2, 5, 0]);
  expect(lengthFigures(-1, "mm", 2)).toBe("\u22120.0394");
  expect(measured(3, "px")).toBe("3\u00a0px");
});

test("comma and point are both decimal signs of a field", () => {
  expect(["0,5", " 0.5 ", ".5", "5.", "-1", "\u22121,5", "1e-3"].map(typedNumber)).toEqual([
    0.5, 0.5, 0.5, 5, -1, -1.5, 0.001,
  ]);
  expect(["", "–", "a", "1,2,3", "1.2.3", "e5", "."].map((text) => Number.isNaN(typedNumber(text)))).toEqual(
    Array(7).fill(true),
  );
  expect([fromTyped("0,25", "mm"), fromTyped("", "mm")]).toEqual([0.25, Number.NaN]);
  for (const system of ["metric", "inch"] as const) {
    chooseUnits(system);
    // as JSON, infinity would be null: nothing was entered
    expect(["1e400", "-1e400", "1e308"].map((text) => JSON.stringify(fromTyped(text, "mm")))).toEqual([
      "1e+300",
      "-1e+300",
      "1e+300",
    ]);
  }
});

test("what is typed in inch is exact in millimetres, and displayed again as typed", () => {
  chooseUnits("inch");
  for (const text of ["0.5", "0.0123", "0.1", "0.000787"]) {
    const value = fromTyped(text, "mm");
    expect(value).toBe(Number((BigInt(text.slice(2)) * 254n).toString()) / 10 ** (text.length - 1));
    expect(typed(value, "mm")).toBe(text);
  }
  expect([fromTyped("1", "mm"), fromTyped(".02", "mm"), fromTyped("-2e1", "mm")]).toEqual([25.4, 0.508, -508]);
  chooseDecimalSign("de");
  expect(typed(12.7, "mm")).toBe("0,5");
  expect(fromTyped("0,5", "mm")).toBe(12.7);
});

test("a field has the language's decimal sign and no groups", () => {
  chooseDecimalSign("de");
  expect([typed(12345.6, "mm"), fieldFigures(-12345.678, 2), fieldFigures(-0.001, 2)]).toEqual([
    "12345,6",
    "-12345,68",
    "0,00",
  ]);
});

test("a length that need not be exact is short in both units", () => {
  expect([55, 1.25, 1000].map((value) => roundTyped(value, "mm", 3))).toEqual(["55", "1.25", "1000"]);
  chooseUnits("inch");
  chooseDecimalSign("de");
  expect([55, 1.25, 1000].map((value) => roundTyped(value, "mm", 3))).toEqual(["2,17", "0,0492", "39,4"]);
});

test("a scale ends at a round number of the displayed unit", () => {
  expect([3, 12, 180, 5000].map((value) => roundEnd(value, "µm", 10, 1000))).toEqual([10, 20, 200, 1000]);
  chooseUnits("inch");
  expect(roundEnd(12, "µm", 10, 1000)).toBeCloseTo(500 * 0.0254, 9);
});
