/** Numbers beside the limits that they are compared with, as exact as in `app/crenel/messages/limits.py`. */

import { type Quantity, quantity } from "../messages/text";

const MOST_DECIMALS = 6;
/** A limit that somebody set has so many decimals more than its value. */
const SET_DECIMALS = 2;
const TINY = 1e-9;

/** So many decimals at least that the size of a value is not rounded to the other side of its limit. */
export function decimalsBeside(value: number, limit: number | null, decimals = 0): number {
  if (limit === null) return decimals;
  const size = Math.abs(value);
  for (let places = decimals; places < MOST_DECIMALS; places++) {
    if (side(size, limit) === side(round(size, places), roundLimit(limit, places))) return places;
  }
  return Math.max(decimals, MOST_DECIMALS);
}

/**
 * A limit beside a value of at least so many decimals, or alone, without zeros at its end. It is not
 * rounded itself, since it may be shown in inch.
 */
export function limitBeside(limit: number, unit: string, decimals = 0, value: number | null = null): Quantity {
  const shown = roundLimit(limit, value === null ? decimals : decimalsBeside(value, limit, decimals));
  return quantity(limit, unit, (String(shown).split(".")[1] ?? "").length);
}

function roundLimit(limit: number, decimals: number): number {
  const stated = round(limit, decimals + SET_DECIMALS);
  return Math.abs(stated - limit) < TINY ? stated : round(limit, decimals);
}

function round(value: number, decimals: number): number {
  return Number(value.toFixed(decimals));
}

function side(value: number, limit: number): number {
  return Math.sign(value - limit);
}
