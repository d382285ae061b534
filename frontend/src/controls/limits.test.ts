import { expect, test } from "vitest";

import { decimalsBeside, limitBeside } from "./limits";

test("a limit that was set is shown as it is, also without its value", () => {
  const limits = [7.5, 60, 12.25, 0.3];
  expect(limits.map((limit) => limitBeside(limit, "µm"))).toEqual(
    [1, 0, 2, 1].map((decimals, i) => ({ value: limits[i], unit: "µm", decimals, signed: false })),
  );
  expect(limitBeside(7.123456, "µm", 1)).toMatchObject({ value: 7.123456, decimals: 1 });
});

test("a value is never rounded to the other side of its limit, nor onto it", () => {
  for (const limit of [0.3, 7.5, 12.25, 60, 7.123456]) {
    for (const off of [0.304 - 0.3, -0.004, 0.0004, -0.0004, 0.04, -0.04, 0.6, 0]) {
      const places = decimalsBeside(-(limit + off), limit, 1);
      const shown = Number((limit + off).toFixed(places));
      const { value, decimals } = limitBeside(limit, "µm", 1, limit + off);
      expect(Math.sign(shown - Number(value.toFixed(decimals)))).toBe(Math.sign(limit + off - limit));
    }
  }
});
