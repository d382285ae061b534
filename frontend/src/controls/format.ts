import { quantity } from "../messages/text";
import { t } from "../state/language";
import { figures, signed } from "./figures";
import { measured } from "./lengths";

export { figures, signed };

export function age(seconds: number): string {
  if (seconds < 1) return measured(seconds, "s", 2);
  if (seconds < 10) return measured(seconds, "s", 1);
  if (seconds < 600) return measured(seconds, "s");
  if (seconds < 7200) return measured(seconds / 60, "min");
  return measured(seconds / 3600, "h");
}

/** The age of something that becomes due after days. */
export function days(value: number): string {
  if (value < 1 / 24) return measured(Math.floor(value * 24 * 60), "min");
  if (value < 1) return t("ui-hours", { n: Math.round(value * 24) });
  return t("ui-days", { n: Math.round(value) });
}

export function daysAgo(value: number): string {
  if (value < 1 / 24) return t("ui-time-ago", { time: quantity(Math.floor(value * 24 * 60), "min") });
  if (value < 1) return t("ui-hours-ago", { n: Math.round(value * 24) });
  return t("ui-days-ago", { n: Math.round(value) });
}

/** The user's time zone, with its offset from UTC today. */
export function timeZone(): string {
  const minutes = -new Date().getTimezoneOffset();
  const hours = Math.floor(Math.abs(minutes) / 60);
  const rest = Math.abs(minutes) % 60;
  const offset = minutes ? `${minutes < 0 ? "−" : "+"}${hours}${rest ? `:${String(rest).padStart(2, "0")}` : ""}` : "";
  const { timeZone: name } = Intl.DateTimeFormat().resolvedOptions();
  return name === "UTC" ? name : `${name}, UTC${offset}`;
}

/** Date and time of day, in the user's time zone. */
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
  return measured(Math.floor(seconds), "s");
}
