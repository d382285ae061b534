import { type Quantity, quantity } from "../messages/text";

/** How every page rounds an uncertainty. The Python counterpart is app/crenel/messages/uncertainty.py. */

const DECIMALS: Record<string, number> = { mm: 4 };
const USUAL_DECIMALS = 1;
const MOST_DECIMALS = 6;
/** Of the standard uncertainty of a scanned point, in µm. */
export const POINT_DECIMALS = 1;

/** So many decimals as usual, or two significant digits of a smaller one. */
export function uncertaintyDecimals(value: number, unit: string): number {
  const usual = DECIMALS[unit] ?? USUAL_DECIMALS;
  if (!(value > 0 && value < 10 ** -usual)) return usual;
  return Math.min(1 - Math.floor(Math.log10(value)), MOST_DECIMALS);
}

/** An expanded uncertainty, rounded as everywhere. */
export function uncertaintyQuantity(value: number, unit: string): Quantity {
  return quantity(value, unit, uncertaintyDecimals(value, unit));
}

/** A part of it, to one decimal more, so that the root of the parts as shown is the whole as shown. */
export function partQuantity(value: number, whole: number, unit: string): Quantity {
  return quantity(value, unit, uncertaintyDecimals(whole, unit) + 1);
}
