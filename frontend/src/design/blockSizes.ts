import type { BlockRequest } from "../api/wire";
import { fromTyped, roundTyped } from "../controls/lengths";
import type { PlainId } from "../messages/text";
import { isWithin, type SliderRange } from "./NumberSlider";

export type SizeName = "width_mm" | "groove_mm" | "tolerance_mm";

/** Sizes of the block that are kept; what is empty is proposed. */
export type SizeFields = Record<SizeName | "merlons", string>;

export const SIZES: Record<SizeName, SliderRange & { label: PlainId }> = {
  width_mm: { label: "ui-width-of-the-block", unit: "mm", low: 6, high: 200, least: 1, most: 1e6 },
  groove_mm: { label: "ui-depth-of-grooves", unit: "mm", low: 1, high: 100, least: 0.1, most: 1e6 },
  tolerance_mm: { label: "ui-tolerance-of-making", unit: "mm", low: 0.002, high: 0.3, least: 0.001, most: 0.3 },
};
export const SIZE_NAMES = Object.keys(SIZES) as SizeName[];
export const MERLONS = [2, 3, 4, 5, 6, 7, 8, 9] as const;

export const NO_SIZES: SizeFields = { width_mm: "", merlons: "", groove_mm: "", tolerance_mm: "" };

/** The sizes of a designed block, as they would be typed. */
export function sizesOf(document: Record<string, unknown>): SizeFields {
  const edges = Array.isArray(document.edges_x_mm) ? document.edges_x_mm.map(Number) : [];
  if (edges.length < 2) return NO_SIZES;
  const length = (mm: number) => roundTyped(mm, "mm", 6);
  return {
    width_mm: length((edges.at(-1) ?? 0) - (edges[0] ?? 0)),
    merlons: String(edges.length / 2),
    groove_mm: length(Number(document.crest_z_mm) - Number(document.floor_z_mm)),
    tolerance_mm: length(Number(document.tolerance_mm)),
  };
}

type GivenSizes = Required<Pick<BlockRequest, SizeName | "merlons">>;

/** What is asked of the station; null while a field holds no such number. */
export function givenSizes(fields: SizeFields): GivenSizes | null {
  if (!SIZE_NAMES.every((name) => fields[name] === "" || isWithin(fields[name], SIZES[name]))) return null;
  const value = (name: SizeName) => (fields[name] === "" ? null : fromTyped(fields[name], "mm"));
  return {
    width_mm: value("width_mm"),
    merlons: fields.merlons === "" ? null : Number(fields.merlons),
    groove_mm: value("groove_mm"),
    tolerance_mm: value("tolerance_mm"),
  };
}
