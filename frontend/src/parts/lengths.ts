/**
 * Lengths as this browser shows them. The station speaks mm and µm; whoever chose inch reads and
 * types inch, and the station is told mm. Files, reports and CSV stay in mm and µm.
 */

import { units } from "../state/units";
import { figures, signed } from "./figures";

/** One of the shown unit is `times` × 10^`power` of the station's, exactly. */
interface Inch {
  unit: string;
  times: bigint;
  power: number;
}

const INCH: Record<string, Inch> = {
  mm: { unit: "in", times: 254n, power: -1 },
  µm: { unit: "µin", times: 254n, power: -4 },
  "mm/s": { unit: "in/s", times: 254n, power: -1 },
  "mm²": { unit: "in²", times: 254n ** 2n, power: -2 },
  "mm³": { unit: "in³", times: 254n ** 3n, power: -3 },
};
/** Of what the station keeps to no round inch, so much is shown in a field. */
const FIELD_DECIMALS: Record<string, number> = { mm: 5, µm: 1 };
/** Nobody types more. */
const TYPED_DECIMALS = 12;

function inch(unit: string): Inch | undefined {
  return units() === "inch" ? INCH[unit] : undefined;
}

function perStation({ times, power }: Inch): number {
  return 10 ** -power / Number(times);
}

/** The unit that stands for the station's; units of other kinds stay. */
export function unitOf(unit: string): string {
  return inch(unit)?.unit ?? unit;
}

/** A length of the station's in the unit that is shown. */
export function inUnit(value: number, unit: string): number {
  const to = inch(unit);
  return to ? value * perStation(to) : value;
}

/** So many decimals that the station's resolution is kept. */
export function decimalsIn(unit: string, decimals: number): number {
  const to = inch(unit);
  return to ? Math.max(0, Math.ceil(decimals - Math.log10(perStation(to)))) : decimals;
}

/**
 * The number alone, in the unit that is shown. In inch it is the metric figure that is converted,
 * as the station's sentences hold it, so that one value reads alike wherever it stands.
 */
export function lengthFigures(value: number, unit: string, decimals = 0, plus = false): string {
  const said = inch(unit) ? Number(value.toFixed(decimals)) : value;
  return (plus ? signed : figures)(inUnit(said, unit), decimalsIn(unit, decimals));
}

/** With its sign always. */
export function signedLength(value: number, unit: string, decimals = 0): string {
  return `${lengthFigures(value, unit, decimals, true)}${behind(unit)}`;
}

/** A number of the station's with its unit: "12 µm" or "472 µin"; other kinds stay. */
export function measured(value: number, unit: string, decimals = 0): string {
  return `${lengthFigures(value, unit, decimals)}${behind(unit)}`;
}

/** Units of angle stand at the number itself; none is parted from it at a line's end. */
function behind(unit: string): string {
  return unit === "″" || unit === "°" ? unit : `\u00a0${unitOf(unit)}`;
}

/** The least round number that holds `value`, of the unit that is shown; in the station's. */
export function roundEnd(value: number, unit: string, least: number, most: number): number {
  const scale = inUnit(1, unit);
  for (let ten = 10 ** Math.floor(Math.log10(least * scale)); ; ten *= 10) {
    for (const round of [ten, 2 * ten, 5 * ten]) {
      if (round / scale >= 0.99 * least && (value <= round / scale || round / scale >= most)) return round / scale;
    }
  }
}

/** What was typed in the unit that is shown, exactly, in the station's. */
export function fromTyped(text: string, unit: string): number {
  const to = inch(unit);
  if (!to) return Number(text);
  const [, sign = "", whole = "", fraction = "", exponent = "0"] =
    /^([+-]?)(\d*)(?:\.(\d*))?(?:e([+-]?\d+))?$/i.exec(text.trim()) ?? [];
  if (whole + fraction === "") return Number.NaN;
  return Number(`${sign}${BigInt(whole + fraction) * to.times}e${to.power - fraction.length + Number(exponent)}`);
}

/** A length of the station's as a field holds it: exactly what would be typed for it, where that is known. */
export function typed(value: number, unit: string): string {
  const to = inch(unit);
  if (!to) return String(Number(value.toPrecision(12)));
  for (let decimals = 0; decimals <= TYPED_DECIMALS; decimals++) {
    const text = inUnit(value, unit).toFixed(decimals);
    if (fromTyped(text, unit) === value) return text;
  }
  return inUnit(value, unit).toFixed(FIELD_DECIMALS[unit] ?? 5);
}

const NUMBER = "[+\u2212-]?\\d[\\d\u2009]*(?:\\.\\d+)?";
const BETWEEN = "[ \u00a0]?(?:[×–±·]|to|bis)[ \u00a0]?";
const LENGTHS = new RegExp(
  `(?<![\\w.])(${NUMBER}(?:${BETWEEN}${NUMBER})*)([ \u00a0]?)(mm²|mm³|mm/s|mm|µm)(?![\\w/²³])`,
  "g",
);

/** A sentence of the station's, the lengths in it in the unit that is shown. */
export function inUnits(text: string): string {
  if (units() === "metric") return text;
  return text.replace(LENGTHS, (_, numbers: string, space: string, unit: string) => {
    const shown = numbers.replace(new RegExp(NUMBER, "g"), (number) => lengthOf(number, unit));
    return `${shown}${space}${unitOf(unit)}`;
  });
}

function lengthOf(number: string, unit: string): string {
  const plain = number.replaceAll("\u2009", "").replace("\u2212", "-");
  const value = inUnit(Number(plain), unit);
  const decimals = decimalsIn(unit, plain.split(".")[1]?.length ?? 0);
  return plain.startsWith("+") ? signed(value, decimals) : figures(value, decimals);
}
