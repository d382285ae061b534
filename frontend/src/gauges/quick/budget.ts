import type { FigureLine, StatisticPart } from "../../api/wire";
import type { Cell, TableData } from "../../controls/table";
import { partQuantity, uncertaintyQuantity } from "../../controls/uncertainty";
import { message, type PlainId, quantity, type Text } from "../../messages/text";

/** What an uncertainty may consist of. */
export const SOURCES: { name: string; title: PlainId }[] = [
  { name: "gauge", title: "ui-gauge" },
  { name: "probe", title: "ui-probe" },
  { name: "points", title: "ui-points" },
  { name: "clouds", title: "ui-clouds" },
];

const STATISTICS = ["mean", "standard_deviation", "range"];

/**
 * Measurement and test value uncertainty of a figure, k = 2. Older records list no budget, and the two do not
 * agree: only the one that the limit is judged by counts.
 */
export function statedUncertainties(figure: FigureLine): { measurement: number | null; test: number | null } {
  const { expanded_uncertainty: measurement, test_uncertainty, budget, judged_by } = figure;
  const test = test_uncertainty === null ? null : 2 * test_uncertainty;
  if (test === null || Object.keys(budget).length > 0) return { measurement, test };
  return judged_by === "test" ? { measurement: null, test } : { measurement, test: null };
}

interface Budgeted {
  title: Text;
  unit: FigureLine["unit"];
  part: StatisticPart;
}

/** What every expanded uncertainty consists of, also those of the statistics over several clouds. */
export function budgetTables(found: FigureLine[]): TableData[] {
  const budgeted = found.flatMap(budgetedOf).filter(({ part }) => Object.keys(part.budget ?? {}).length > 0);
  const known = SOURCES.filter(({ name }) => budgeted.some(({ part }) => part.budget?.[name] !== undefined));
  if (budgeted.length === 0) return [];
  return [
    {
      title: "ui-uncertainty-budgets",
      head: ["ui-figure", "ui-value", "ui-u-k-2", ...known.map(({ title }) => title), "ui-unit"],
      rows: budgeted.map((line) => [
        line.title,
        quantity(line.part.value, line.unit, 1),
        uncertaintyQuantity(line.part.expanded_uncertainty, line.unit),
        ...known.map(({ name }) => partCell(line, name)),
        { unit: line.unit },
      ]),
      wide: true,
    },
  ];
}

function budgetedOf({ title, unit, spread, value, expanded_uncertainty, budget }: FigureLine): Budgeted[] {
  const statistics = STATISTICS.flatMap((of) => {
    const part = spread[of];
    return part ? [{ title: message("ui-figure-over-clouds", { title, of }), unit, part }] : [];
  });
  return [{ title, unit, part: { value, expanded_uncertainty, budget } }, ...statistics];
}

function partCell({ part: { expanded_uncertainty: whole, budget }, unit }: Budgeted, source: string): Cell {
  const value = budget?.[source];
  return value === undefined ? "–" : partQuantity(2 * value, whole, unit);
}
