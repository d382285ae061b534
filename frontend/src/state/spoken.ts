import { heardSince, said } from "./language";
import { units } from "./units";

/** Where the station puts sentences and words; all else are names, numbers and keys. */
const SENTENCES = new Set([
  ...["text", "title", "label", "note", "detail", "remedy", "why_not", "confirm", "instruction", "words", "wanted"],
  ...["reason", "verdict_text", "what", "why", "trouble", "progress", "source", "act", "action"],
]);
/** What is sent back as it came, and what others say: that is looked up where it is shown. */
const KEPT = new Set(["args", "stations"]);

let done = new WeakMap<object, unknown>();
/** From what was said to what the station sent. */
const sent = new WeakMap<object, object>();
let since = wording();

/**
 * What the station sent, with its sentences in this browser's language. The same for the same;
 * what holds no sentence is given back itself.
 */
export function spoken<T>(value: T): T {
  if (since !== wording()) {
    since = wording();
    done = new WeakMap();
  }
  return since === "" ? value : (walked(value) as T);
}

/** What the station sent, as it was before it was put into this browser's language: for files. */
export function asSent<T extends object>(value: T): T {
  return (sent.get(value) ?? value) as T;
}

/** In what language and units sentences are said; nothing while they are said as they come. */
function wording(): string {
  return heardSince() === 0 && units() === "metric" ? "" : `${heardSince()} ${units()}`;
}

function walked(value: unknown): unknown {
  if (typeof value !== "object" || value === null) return value;
  const known = done.get(value);
  if (known !== undefined) return known;
  const result = Array.isArray(value) ? list(value) : record(value as Record<string, unknown>);
  done.set(value, result);
  if (result !== value) sent.set(result, value);
  return result;
}

function list(values: unknown[]): unknown[] {
  // rows of numbers, as of an outline, are long
  if (typeof values[0] === "number") return values;
  const result = values.map(walked);
  return result.some((one, i) => one !== values[i]) ? result : values;
}

function record(fields: Record<string, unknown>): Record<string, unknown> {
  let result = fields;
  for (const [key, value] of Object.entries(fields)) {
    if (KEPT.has(key)) continue;
    const now = typeof value === "string" ? (SENTENCES.has(key) ? said(value) : value) : walked(value);
    if (now === value) continue;
    if (result === fields) result = { ...fields };
    result[key] = now;
  }
  return result;
}
