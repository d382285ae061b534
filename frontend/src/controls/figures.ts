/** Number format of the chosen language. */

const MINUS = "\u2212";
let point = ".";

/** The decimal sign of the chosen language. */
export function decimalSign(): string {
  return point;
}

export function chooseDecimalSign(language: string): void {
  const parts = new Intl.NumberFormat(language, { numberingSystem: "latn" }).formatToParts(0.5);
  point = parts.find(({ type }) => type === "decimal")?.value ?? ".";
}

/** With decimals below zero, to tens or hundreds. */
function rounded(value: number, decimals: number): string {
  const step = 10 ** Math.max(-decimals, 0);
  return (Math.round(value / step) * step).toFixed(0);
}

/** A number with a true minus sign and a thin space between thousands. */
export function figures(value: number, decimals = 0): string {
  if (!Number.isFinite(value)) return "–";
  const text = decimals < 0 ? rounded(Math.abs(value), decimals) : Math.abs(value).toFixed(decimals);
  const [whole = "", fraction] = text.split(".");
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, "\u2009") : whole;
  const sign = value < 0 && Number(text) !== 0 ? MINUS : "";
  return sign + grouped + (fraction ? point + fraction : "");
}

/** With its sign always. */
export function signed(value: number, decimals = 0): string {
  const text = figures(value, decimals);
  return value > 0 && /[1-9]/.test(text) ? `+${text}` : text;
}

/** For files: with a decimal point, in any language. */
export function plainFigures(value: number, decimals = 0): string {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace("-", "") : text;
}
