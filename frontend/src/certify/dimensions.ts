/** What is read from a block with an instrument, and the table that its readings make. */

import type { Vec3 } from "../api/types";
import type { BlockGeometry } from "../api/wire";
import { fromTyped } from "../controls/lengths";
import { t } from "../state/language";

export type Instrument = "calliper" | "micrometer";

/** The distance of two parallel faces, which tables name so. */
export interface Dimension {
  from: string;
  to: string;
  label: string;
  /** The others reach every face without it: it checks them. */
  optional: boolean;
}

/** What an instrument has on its scale and in its certificate, as typed. */
export interface InstrumentNumbers {
  resolution: string;
  /** Expanded, k = 2. */
  uncertainty: string;
}

const LARGEST_SD_MM = 0.1;

export const keyOf = ({ from, to }: Dimension) => `${from} ${to}`;

/** The dimensions that an instrument reaches; a micrometer measures from outside only. */
export function dimensionsOf(edges: number, instrument: Instrument): Dimension[] {
  const merlons = Array.from({ length: edges / 2 }, (_, i) => i + 1);
  const inner = merlons.slice(0, -1);
  const outside = instrument === "micrometer";
  return [
    ...merlons.map((n) => of(`edge_${2 * n - 1}`, `edge_${2 * n}`, t("ui-merlon-n", { n }))),
    ...inner.map((n) =>
      outside
        ? of(`edge_${2 * n - 1}`, `edge_${2 * n + 2}`, t("ui-merlons-n-to-m", { n, m: n + 1 }))
        : of(`edge_${2 * n}`, `edge_${2 * n + 1}`, t("ui-groove-n", { n })),
    ),
    ...(outside && edges === 4 ? [] : [of("edge_1", `edge_${edges}`, t("ui-overall-length"), true)]),
    of("front", "back", t("ui-block-depth")),
    of("base", "crest", t("ui-block-height")),
    of("floor", "crest", t("ui-depth-of-grooves"), outside),
    of("base", "floor", t("ui-height-of-floors"), !outside),
  ];
}

const of = (from: string, to: string, label: string, optional = false): Dimension => ({ from, to, label, optional });

/** The standard uncertainties of a reading by itself and of what all readings share, mm; null while they are none.
 *  The certificate does not say how its uncertainty divides: it counts in both. */
export function sdsOf({ resolution, uncertainty }: InstrumentNumbers): { own: number; common: number } | null {
  const step = fromTyped(resolution, "mm");
  const common = fromTyped(uncertainty, "mm") / 2;
  const own = Math.hypot(step / Math.sqrt(12), common);
  return step > 0 && common >= 0 && own <= LARGEST_SD_MM ? { own, common } : null;
}

/** The table of the readings that are typed; empty while there is none, null while one is no number. */
export function readingsTable(
  dimensions: Dimension[],
  typed: Record<string, string>,
  instrument: Instrument,
  numbers: InstrumentNumbers,
): string | null {
  const sds = sdsOf(numbers);
  const filled = dimensions.filter((one) => typed[keyOf(one)]?.trim());
  if (filled.length === 0) return "";
  const rows = filled.map((one) => ({ ...one, mm: fromTyped(typed[keyOf(one)] ?? "", "mm") }));
  if (!sds || rows.some(({ mm }) => Number.isNaN(mm))) return null;
  const tail = `${sds.own.toFixed(6)},${instrument},${sds.common.toFixed(6)}`;
  return [
    "from,to,distance_mm,standard_uncertainty_mm,tool,tool_uncertainty_mm",
    ...rows.map(({ from, to, mm }) => `${from},${to},${mm},${tail}`),
    "",
  ].join("\n");
}

/** How far a dimension line stands off, as a share of the height of the merlons. */
const OFF = 0.35;

/** Both ends of a dimension on the block, and of its line beside it. */
export function dimensionLine(block: BlockGeometry, { from, to }: Dimension): { at: Vec3; beside: Vec3 }[] {
  const { edges_x_mm: edges, front_y_mm: front, back_y_mm: back, crest_z_mm: crest } = block;
  const [left = 0, right = 0] = [edges[0], edges[edges.length - 1]];
  const off = OFF * (crest - block.floor_z_mm);
  const heights: Record<string, number> = { crest, floor: block.floor_z_mm, base: block.base_z_mm };
  return [from, to].map((face) => {
    const edge = /^edge_(\d+)$/.exec(face);
    if (edge) {
      const x = edges[Number(edge[1]) - 1] ?? 0;
      return { at: [x, front, crest] as Vec3, beside: [x, front, crest + off] as Vec3 };
    }
    const z = heights[face];
    if (z === undefined) {
      const y = face === "front" ? front : back;
      return { at: [right, y, crest] as Vec3, beside: [right + off, y, crest] as Vec3 };
    }
    const x = face === "floor" ? (edges[1] ?? left) : left;
    return { at: [x, front, z] as Vec3, beside: [left - off, front, z] as Vec3 };
  });
}

/** As it was drawn, mm. */
export function drawnLength(block: BlockGeometry, dimension: Dimension): number {
  const [first, second] = dimensionLine(block, dimension);
  return first && second ? Math.max(...first.at.map((one, i) => Math.abs(one - (second.at[i] ?? 0)))) : Number.NaN;
}
