import { useSetting } from "../state/useSetting";
import { fromTyped, typed } from "./lengths";

/** A field for a length: typed in the displayed unit, with its value in the station's unit. */
export function useLengthField(current: number | null, unit: string) {
  const field = useSetting(current === null ? "" : typed(current, unit));
  const text = field.text.trim();
  const value = !field.changed ? current : text === "" ? null : fromTyped(text, unit);
  return { ...field, value, valid: value === null || Number.isFinite(value) };
}
