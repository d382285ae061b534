import { counted, t } from "../state/language";
import { figures, signed } from "./figures";

export { figures, signed };

export function age(seconds: number): string {
  if (seconds < 1) return `${figures(seconds, 2)} s`;
  if (seconds < 10) return `${figures(seconds, 1)} s`;
  if (seconds < 120) return `${figures(seconds)} s`;
  if (seconds < 7200) return `${figures(seconds / 60)} min`;
  return `${figures(seconds / 3600)} h`;
}

/** How old something is that comes of age in days. */
export function days(value: number): string {
  if (value < 1 / 24) return `${Math.floor(value * 24 * 60)} min`;
  if (value < 1) return counted(Math.round(value * 24), "{n} hour", "{n} hours");
  return counted(Math.round(value), "{n} day", "{n} days");
}

export function daysAgo(value: number): string {
  if (value < 1 / 24) return t("{n} min ago", { n: Math.floor(value * 24 * 60) });
  if (value < 1) return counted(Math.round(value * 24), "{n} hour ago", "{n} hours ago");
  return counted(Math.round(value), "{n} day ago", "{n} days ago");
}

/** Date and time of day, in the operator's own zone. */
export function moment(iso: string): string {
  const date = new Date(iso);
  if (Number.isNaN(date.getTime())) return iso;
  const two = (part: number) => String(part).padStart(2, "0");
  return (
    `${date.getFullYear()}-${two(date.getMonth() + 1)}-${two(date.getDate())} ` +
    `${two(date.getHours())}:${two(date.getMinutes())}`
  );
}

export function duration(seconds: number): string {
  const whole = Math.floor(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")} min`;
}

const UNITS = /(\d) (?=(?:µm|mm|µin|in|px|%|s|ms|µs|Hz|fps|GB|nm|°C|min|h|days?)(?![a-z]))/g;

/** The same words, a number never parted from its unit at a line's end. */
export function bound(text: string): string {
  return text
    .replace(UNITS, "$1\u00a0")
    .replaceAll(" rms", "\u00a0rms")
    .replaceAll("k = ", "k\u00a0=\u00a0")
    .replaceAll(/ ([×Ø]) (?=\d)/g, "\u00a0$1\u00a0");
}
