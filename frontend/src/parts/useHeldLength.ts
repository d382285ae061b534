import { useHeld } from "../state/useHeld";
import { fromTyped, typed } from "./lengths";

/** A field for a length: typed in the unit that is shown, its value in the station's. */
export function useHeldLength(held: number | null, unit: string) {
  const field = useHeld(held === null ? "" : typed(held, unit));
  const text = field.text.trim();
  return { ...field, value: !field.changed ? held : text === "" ? null : fromTyped(text, unit) };
}
