import type { Quality } from "../api/types";
import type { DimensionLine } from "../api/wire";
import { figures, signed } from "../controls/figures";
import { measured, signedLength } from "../controls/lengths";
import type { PlainId } from "../messages/text";

export type Outcome = DimensionLine["decision"];

export const OUTCOMES: Record<Outcome, PlainId> = {
  pass: "ui-part-in",
  fail: "ui-part-out",
  undecided: "ui-part-undecided",
  none: "ui-part-not-decided",
};
export const OUTCOME_QUALITY: Record<Outcome, Quality> = {
  pass: "good",
  fail: "bad",
  undecided: "attention",
  none: "neutral",
};

/** A value of a dimension with its unit; angles stay in degrees. */
export function shown(value: number, { unit, decimals }: DimensionLine): string {
  return unit === "°" ? `${figures(value, decimals)}°` : measured(value, unit, decimals);
}

/** A deviation, with its sign. */
export function shownDeviation(value: number, { unit, decimals }: DimensionLine): string {
  return unit === "°" ? `${signed(value, decimals)}°` : signedLength(value, unit, decimals);
}

/** U, or what the points scatter by. */
export function spreadOf(line: DimensionLine): number | null {
  return line.expanded ?? line.scatter;
}
