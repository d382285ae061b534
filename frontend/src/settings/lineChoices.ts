import type { StationSettings } from "../api/wire";
import type { PlainId } from "../messages/text";

export type LineChoice = StationSettings["choice"];

/** Which of several lines of a column is taken. */
export const LINE_CHOICES: { value: LineChoice; label: PlainId }[] = [
  { value: "continuity", label: "ui-the-longest-line-automatic" },
  { value: "strength", label: "ui-the-brightest" },
  { value: "first", label: "ui-the-first-from-the-pictures-top" },
  { value: "last", label: "ui-the-last-from-the-pictures-top" },
];
