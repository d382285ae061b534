import { expect, test } from "vitest";
import { DEVIATION_CSS, deviationColour } from "./deviationColours";
import STOPS from "./deviationStops.json";

function hex(colour: string): string {
  const parts = colour.match(/\d+/g) ?? [];
  return `#${parts.map((part) => Number(part).toString(16).padStart(2, "0")).join("")}`;
}

test("deviations have the colours of the station's scale, which the legend shows", () => {
  const shares = STOPS.map((_, i) => (2 * i) / (STOPS.length - 1) - 1);
  expect(shares.map((share) => hex(deviationColour(share)))).toEqual(STOPS);
  expect([deviationColour(-9), deviationColour(9)].map(hex)).toEqual([STOPS[0], STOPS[STOPS.length - 1]]);
  expect(DEVIATION_CSS).toBe(`linear-gradient(90deg, ${STOPS.join(", ")})`);
});
