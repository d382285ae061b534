import { isMessage, isMessageList, isQuantity, type Text } from "../messages/text";
import { currentLanguage, isKnown, render } from "./language";
import { units } from "./units";

/** Sent back as it came. */
const UNCHANGED = "args";
/** A field with this suffix has the message of another field, which has the English text. */
const DATA = "_message";

let done = new WeakMap<object, unknown>();
/** From a localized value to what the station sent. */
const originals = new WeakMap<object, object>();
let wording = currentWording();

/**
 * What the station sent, with its messages in this browser's language and units. Equal input gives
 * the same object; input without messages is returned unchanged.
 */
export function localized<T>(value: T): T {
  if (wording !== currentWording()) {
    wording = currentWording();
    done = new WeakMap();
  }
  return walk(value) as T;
}

/** What the station sent, before it was localized: for files. */
export function asSent<T extends object>(value: T): T {
  return (originals.get(value) ?? value) as T;
}

/** A text, or its English version if this version of the client has no such message. */
export function restored(english: string, data: unknown): string {
  return isText(data) && isKnown(data) ? render(data) : english;
}

function currentWording(): string {
  return `${currentLanguage()} ${units()}`;
}

function isText(value: unknown): value is Exclude<Text, string> {
  return typeof value === "object" && value !== null && (isMessage(value) || isMessageList(value) || isQuantity(value));
}

function walk(value: unknown): unknown {
  if (typeof value !== "object" || value === null) return value;
  if (isText(value)) return render(value);
  const known = done.get(value);
  if (known !== undefined) return known;
  const result = Array.isArray(value) ? list(value) : record(value as Record<string, unknown>);
  done.set(value, result);
  if (result !== value) originals.set(result, value);
  return result;
}

function list(values: unknown[]): unknown[] {
  // rows of numbers, such as an outline, are long
  if (typeof values[0] === "number") return values;
  const result = values.map(walk);
  return result.some((one, i) => one !== values[i]) ? result : values;
}

function record(fields: Record<string, unknown>): Record<string, unknown> {
  let result = fields;
  for (const [key, value] of Object.entries(fields)) {
    if (key === UNCHANGED) continue;
    const data = fields[key + DATA];
    const now = data ? withData(value, data) : walk(value);
    if (now === value) continue;
    if (result === fields) result = { ...fields };
    result[key] = now;
  }
  return result;
}

/** English with its text, or a list of them. */
function withData(english: unknown, data: unknown): unknown {
  if (typeof english === "string") return restored(english, data);
  if (!Array.isArray(english) || !Array.isArray(data)) return walk(english);
  return english.map((one, i) => (typeof one === "string" ? restored(one, data[i]) : walk(one)));
}
