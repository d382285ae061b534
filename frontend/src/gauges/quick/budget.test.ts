import { expect, test } from "vitest";
import type { FigureLine } from "../../api/wire";
import { plainFigures } from "../../controls/figures";
import { displayedCell, fileCell } from "../../controls/table";
import { partQuantity, uncertaintyQuantity } from "../../controls/uncertainty";
import cases from "../../controls/uncertaintyCases.json";
import { budgetTables, statedUncertainties } from "./budget";
import { tablesOf } from "./verification";

const FORM: FigureLine = {
  name: "form",
  title: "Form",
  unit: "µm",
  value: 42.11,
  expanded_uncertainty: 2 * Math.hypot(1.237, 0.311),
  budget: { gauge: 1.237, points: 0.311 },
  test_uncertainty: 1.237,
  judged_by: "test",
  limit: 100,
  decision: "pass",
  reason: "",
  clouds: [40, 42.11],
  spread: {
    mean: { value: 41, expanded_uncertainty: 2 * Math.hypot(1.237, 3.3), budget: { gauge: 1.237, clouds: 3.3 } },
    range: { value: 2.11, expanded_uncertainty: 2 * 0.44, budget: { points: 0.44 } },
  },
};

test.each(cases)("$value $unit is rounded as in the station", ({ value, unit, shown, part }) => {
  const texts = [uncertaintyQuantity(value, unit), partQuantity(value, value, unit)];
  expect(texts.map((one) => plainFigures(one.value, one.decimals))).toEqual([shown, part]);
});

test("every U of the tables is the root of its parts, and stated once, in the page and in its CSV", () => {
  const figures = [FORM, { ...FORM, name: "rms", unit: "″", clouds: [], spread: {} }];
  const [budgets] = budgetTables(figures);
  for (const row of budgets?.rows ?? []) {
    for (const cell of [displayedCell, fileCell]) {
      const [U = Number.NaN, ...parts] = row.slice(2, -1).map((one) => Number(cell(one).replace("–", "0")));
      expect(Math.abs(Math.hypot(...parts) - U)).toBeLessThan(0.06);
    }
  }
  expect(budgets?.rows.map((row) => fileCell(row[0] ?? ""))).toEqual([
    "Form",
    "Form: mean over the clouds",
    "Form: range over the clouds",
    "Form",
  ]);
  const [stated] = tablesOf({
    figures,
    clouds: [],
    shape: "plane",
    verdict: null,
    notes: [],
    rule: null,
    filters: null,
  });
  expect(stated?.rows[0]?.slice(2, 4).map(fileCell)).toEqual(["2.6", "2.5"]);
  expect(fileCell(budgets?.rows[0]?.[2] ?? "")).toBe("2.6");
});

test("an older record states the uncertainty that it was judged by alone", () => {
  const older = { ...FORM, budget: {}, spread: {}, expanded_uncertainty: 1.2 };
  expect(statedUncertainties(older)).toEqual({ measurement: null, test: 2.474 });
  expect(statedUncertainties({ ...older, judged_by: "measurement" })).toEqual({ measurement: 1.2, test: null });
  expect(budgetTables([older])).toEqual([]);
});
