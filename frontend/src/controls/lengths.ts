/**
 * Lengths as this browser shows them. The station uses mm and µm; if inch is selected, users read and
 * type inches, and the station receives mm. Files, reports and CSV use mm and µm.
 */

import type { Quantity } from "../messages/text";
import { units } from "../state/units";
import { decimalSign, figures, plainFigures, signed } from "./figures";

/** One of the displayed unit is `times` × 10^`power` of the station's, exactly. */
interface Inch {
  unit: string;
  times: bigint;
  power: number;
}

const INCH: Record<string, Inch> = {
  mm: { unit: "in", times: 254n, power: -1 },
  µm: { unit: "µin", times: 254n, power: -4 },
  nm: { unit: "µin", times: 254n, power: -1 },
  "mm/s": { unit: "in/s", times: 254n, power: -1 },
  "mm²": { unit: "in²", times: 254n ** 2n, power: -2 },
  "mm³": { unit: "in³", times: 254n ** 3n, power: -3 },
};
/** Decimals that a field shows of stored values that are not round in inches. */
const FIELD_DECIMALS: Record<string, number> = { mm: 5, µm: 1 };
/** Larger than every number that the station takes, also times a scale. */
const LARGEST = 1e300;
/** Maximum length of a typed number. */
const TYPED_DECIMALS = 12;
/** Units without a space before them. */
const TIGHT = new Set(["", "°", "′", "″"]);

function inch(unit: string): Inch | undefined {
  return units() === "inch" ? INCH[unit] : undefined;
}

function perStation({ times, power }: Inch): number {
  return 10 ** -power / Number(times);
}

/** The displayed unit for a unit of the station; units of other kinds stay. */
export function unitOf(unit: string): string {
  return inch(unit)?.unit ?? unit;
}

/** A length from the station in the displayed unit. */
export function inUnit(value: number, unit: string): number {
  const to = inch(unit);
  return to ? value * perStation(to) : value;
}

/** So many decimals that the station's resolution is preserved; below zero, to tens or hundreds. */
export function decimalsIn(unit: string, decimals: number): number {
  const to = inch(unit);
  return to ? Math.ceil(decimals - Math.log10(perStation(to))) + 0 : decimals; // never -0
}

/**
 * The number alone, in the displayed unit. It is rounded once, in that unit, so that figures of one
 * value with more and with fewer decimals agree.
 */
export function lengthFigures(value: number, unit: string, decimals = 0, plus = false): string {
  if (!Number.isFinite(value)) return figures(value);
  return (plus ? signed : figures)(inUnit(value, unit), decimalsIn(unit, decimals));
}

/** With its sign always. */
export function signedLength(value: number, unit: string, decimals = 0): string {
  return `${lengthFigures(value, unit, decimals, true)}${behind(unit)}`;
}

/** A number from the station with its unit: "12 µm" or "470 µin"; whole seconds as "2 min 57 s". */
export function measured(value: number, unit: string, decimals = 0): string {
  if (unit === "s" && decimals === 0 && value >= MINUTE_S) return inMinutes(value);
  return `${lengthFigures(value, unit, decimals)}${behind(unit)}`;
}

export function displayed({ value, unit, decimals, signed: plus }: Quantity): string {
  return (plus ? signedLength : measured)(value, unit, decimals);
}

const MINUTE_S = 60;

/** "2 min 57 s", from an hour on "1 h 2 min"; the Python counterpart is in app/crenel/messages/catalogue.py. */
function inMinutes(seconds: number): string {
  const whole = Math.round(seconds);
  const parts: [number, string][] = [
    [Math.floor(whole / 3600), "h"],
    [Math.floor(whole / 60) % 60, "min"],
    [whole % 60, "s"],
  ];
  const said = parts[0]?.[0] ? parts.slice(0, 2) : parts.slice(1);
  return said
    .filter(([n]) => n > 0)
    .map(([n, unit]) => `${n}${behind(unit)}`)
    .join("\u00a0");
}

/** Never separated from its number by a line break. */
function behind(unit: string): string {
  return TIGHT.has(unit) ? unit : `\u00a0${unitOf(unit)}`;
}

/** The smallest round number in the displayed unit that is at least `value`; in the station's unit. */
export function roundEnd(value: number, unit: string, least: number, most: number): number {
  const scale = inUnit(1, unit);
  for (let ten = 10 ** Math.floor(Math.log10(least * scale)); ; ten *= 10) {
    for (const round of [ten, 2 * ten, 5 * ten]) {
      if (round / scale >= 0.99 * least && (value <= round / scale || round / scale >= most)) return round / scale;
    }
  }
}

/** A typed number; comma and point are both decimal signs. NaN if it is not a number. */
export function typedNumber(text: string): number {
  const plain = text.trim().replace(",", ".");
  return /^[+\-\u2212]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain)
    ? finite(Number(plain.replace("\u2212", "-")))
    : Number.NaN;
}

/** JSON has no infinite numbers and would send none at all: the station refuses so large a one by name. */
function finite(value: number): number {
  return Math.min(Math.max(value, -LARGEST), LARGEST);
}

/** The exact value, in the station's unit, of what was typed in the displayed unit. */
export function fromTyped(text: string, unit: string): number {
  const to = inch(unit);
  const value = typedNumber(text);
  if (!to || Number.isNaN(value)) return value;
  const [, sign = "", whole = "", fraction = "", exponent = "0"] =
    /^([+\-\u2212]?)(\d*)(?:[.,](\d*))?(?:e([+-]?\d+))?$/i.exec(text.trim()) ?? [];
  const minus = sign && sign !== "+" ? "-" : "";
  return finite(
    Number(`${minus}${BigInt(whole + fraction) * to.times}e${to.power - fraction.length + Number(exponent)}`),
  );
}

/** A number as a field shows it. */
export function fieldFigures(value: number, decimals: number): string {
  return plainFigures(value, decimals).replace(".", decimalSign());
}

/** A length from the station as a field shows it: exactly what would be typed for it, if that is known. */
export function typed(value: number, unit: string): string {
  return plainTyped(value, unit).replace(".", decimalSign());
}

/** A length that need not be exact, as somebody would type it: to so many digits of the displayed unit. */
export function roundTyped(value: number, unit: string, digits: number): string {
  return String(Number(inUnit(value, unit).toPrecision(digits))).replace(".", decimalSign());
}

function plainTyped(value: number, unit: string): string {
  const to = inch(unit);
  if (!to) return String(Number(value.toPrecision(12)));
  for (let decimals = 0; decimals <= TYPED_DECIMALS; decimals++) {
    const text = inUnit(value, unit).toFixed(decimals);
    if (fromTyped(text, unit) === value) return text;
  }
  return inUnit(value, unit).toFixed(FIELD_DECIMALS[unit] ?? 5);
}
