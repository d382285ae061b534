import { describe, expect, it } from "vitest";

import type { Vec3 } from "../api/types";
import { chainOf } from "./chain";
import cases from "./chainCases.json";

const far = (a: Vec3, b: readonly number[]) => Math.hypot(...a.map((value, i) => value - (b[i] ?? Number.NaN)));

describe("the chain of an arm", () => {
  it.each(cases)("has its tip where the station has it: $name", ({ document, q_deg, tip_mm }) => {
    const chain = chainOf(document, q_deg);
    expect(chain?.tip && far(chain.tip, tip_mm)).toBeLessThan(1e-6);
  });
});
