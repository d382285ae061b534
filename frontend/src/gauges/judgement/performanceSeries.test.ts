import { expect, test } from "vitest";

import type { PerformanceSymbols, SymbolValue } from "../../api/wire";
import { listSeries } from "./performanceSeries";

function found(quantity: string, value: number): SymbolValue {
  return {
    quantity,
    symbol: quantity,
    title: quantity,
    signed: true,
    value,
    test_uncertainty: 1,
    limit: null,
    decision: "none",
  };
}

function tested(id: string, artefact_kind: string, symbols: SymbolValue[], arm_serial = "A-1"): PerformanceSymbols {
  return { id, ended_at: `2026-11-${id}`, artefact_kind, arm_serial, rule: "", symbols };
}

test("a test of another kind does not hide the symbols of those before", () => {
  const series = listSeries([
    tested("01", "sphere", [found("size-touch", 1), found("form-touch", 2)]),
    tested("02", "sphere", [found("size-touch", 3), found("form-touch", 4)], "A-2"),
    tested("03", "sphere", [found("size-touch", 5)]),
    tested("04", "ball-bar", [found("length-touch", 6)]),
    tested("05", "step-gauge", [found("length-touch", 7)]),
    tested("06", "step-gauge", [found("length-touch", 8)]),
    tested("07", "plane", [found("plane-scan", 9)]),
  ]);
  expect(series.map(({ key, points }) => [key, points.map((point) => point.found.value)])).toEqual([
    ["step-gauge/length-touch", [7, 8]],
    ["sphere/size-touch", [1, 5]],
  ]);
  expect(series[0]?.label).toContain("Step gauge");
});
