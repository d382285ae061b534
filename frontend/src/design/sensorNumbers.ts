import type { SensorNumbers } from "../api/designCommands";
import { fromTyped, roundTyped } from "../controls/lengths";
import type { PlainId } from "../messages/text";
import { isWithin, type SliderRange } from "./NumberSlider";

/** What stands in the fields. */
export type SensorFields = Record<SliderName | "width_px" | "height_px", string> & { stripe_axis: "u" | "v" };

export type SliderName = "field_of_view_mm" | "standoff_mm" | "depth_of_field_mm" | "angle_deg";

export const SLIDERS: Record<SliderName, SliderRange & { label: PlainId }> = {
  field_of_view_mm: { label: "ui-field-of-view", unit: "mm", low: 5, high: 500, least: 1, most: 1e6 },
  standoff_mm: { label: "ui-stand-off", unit: "mm", low: 20, high: 1000, least: 1, most: 1e6 },
  depth_of_field_mm: { label: "ui-depth-of-field", unit: "mm", low: 1, high: 250, least: 0.5, most: 1e6 },
  angle_deg: { label: "ui-angle-between-laser-and-camera", unit: "°", low: 5, high: 70, least: 5, most: 70 },
};
export const SLIDER_NAMES = Object.keys(SLIDERS) as SliderName[];

export const PIXELS: SliderRange = { unit: "px", low: 64, high: 8192, least: 1, most: 65536 };

/** A usual sensor, from which the sliders begin. */
const USUAL = { field_of_view_mm: 55, standoff_mm: 115, depth_of_field_mm: 20, angle_deg: 30 };

export function firstFields(): SensorFields {
  const sliders = SLIDER_NAMES.map((name) => [name, roundTyped(USUAL[name], SLIDERS[name].unit, 3)]);
  return { ...Object.fromEntries(sliders), width_px: "1280", height_px: "1024", stripe_axis: "u" } as SensorFields;
}

/** The fields with what a datasheet says; what it does not say stays. */
export function withDatasheet(fields: SensorFields, document: Record<string, unknown>): SensorFields {
  const { width_px, height_px, stripe_axis, standoff_mm, focal_px } = document;
  const filled: SensorFields = {
    ...fields,
    width_px: String(width_px),
    height_px: String(height_px),
    stripe_axis: stripe_axis === "v" ? "v" : "u",
  };
  if (typeof standoff_mm !== "number") return filled;
  filled.standoff_mm = roundTyped(standoff_mm, "mm", 5);
  if (typeof focal_px === "number") {
    const along_px = Number(stripe_axis === "v" ? height_px : width_px);
    filled.field_of_view_mm = roundTyped((along_px * standoff_mm) / focal_px, "mm", 3);
  }
  return filled;
}

/** What is asked of the station; null while a field holds no such number. */
export function numbersOf(fields: SensorFields): Omit<SensorNumbers, "arm" | "arm_version"> | null {
  const pixels = [fields.width_px, fields.height_px].map(Number);
  if (!SLIDER_NAMES.every((name) => isWithin(fields[name], SLIDERS[name]))) return null;
  if (!pixels.every((count) => Number.isInteger(count) && count >= PIXELS.least && count <= PIXELS.most)) return null;
  const [width_px = 0, height_px = 0] = pixels;
  const value = (name: SliderName) => fromTyped(fields[name], SLIDERS[name].unit);
  return {
    field_of_view_mm: value("field_of_view_mm"),
    standoff_mm: value("standoff_mm"),
    depth_of_field_mm: value("depth_of_field_mm"),
    angle_deg: value("angle_deg"),
    width_px,
    height_px,
    stripe_axis: fields.stripe_axis,
  };
}
