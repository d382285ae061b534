/** Renders messages from the language files, with Project Fluent's library. */

import { FluentBundle, FluentNumber, FluentResource, type FluentValue } from "@fluent/bundle";

import { isolated } from "../state/isolated";
import { isMessage, isMessageList, type Quantity, type Text, type Value } from "./text";

/** How numbers are written. */
export interface NumberFormat {
  quantity(quantity: Quantity): string;
  count(value: number): string;
}

/** A number that selects a plural, in the usual number format. */
class Count extends FluentNumber {
  constructor(
    value: number,
    private readonly written: string,
  ) {
    super(value);
  }

  override toString(): string {
    return this.written;
  }
}

/** Functions of the language files for inserted texts, as in app/crenel/messages/catalogue.py. */
const FUNCTIONS = {
  CAPITAL: ([text]: FluentValue[]) => capital(String(text)),
  CLAUSE: ([text]: FluentValue[]) => String(text).trim().replace(/\.+$/, ""),
};

/** A path or the name of a file at the beginning of a text. */
const FILE = /^[^\s:,]*[/\\._][\p{L}\p{N}_]/u;

/** With a capital letter, unless it begins with a file name. */
function capital(text: string): string {
  return FILE.test(text) ? text : text.charAt(0).toUpperCase() + text.slice(1);
}

/** One language. A text that it lacks comes from the fallback. */
export class Catalogue {
  private readonly bundle: FluentBundle;

  constructor(
    language: string,
    source: string,
    private readonly format: NumberFormat,
    private readonly fallback?: Catalogue,
  ) {
    this.bundle = new FluentBundle(language, { functions: FUNCTIONS, useIsolating: false });
    this.bundle.addResource(new FluentResource(typeset(source)));
  }

  has(id: string): boolean {
    return this.bundle.hasMessage(id) || (this.fallback?.has(id) ?? false);
  }

  /** Whether every message in a text is known, for texts of other versions of Crenel. */
  knows(text: Value): boolean {
    if (typeof text !== "object") return true;
    if (isMessage(text))
      return this.has(text.message_id) && Object.values(text.values).every((value) => this.knows(value));
    return !isMessageList(text) || text.items.every((item) => this.knows(item));
  }

  /** The text in this language; an unknown id stands for itself. */
  render(text: Text): string {
    if (typeof text === "string") return text;
    if (isMessage(text)) return this.message(text.message_id, text.values);
    if (isMessageList(text)) return text.items.map((item) => this.part(item)).join(text.separator);
    return this.format.quantity(text);
  }

  message(id: string, values: Readonly<Record<string, Value>>): string {
    const pattern = this.bundle.getMessage(id)?.value;
    if (!pattern) return this.fallback ? this.fallback.message(id, values) : id;
    const places = Object.entries(values).map(([name, value]): [string, FluentValue] => [name, this.value(value)]);
    return this.bundle.formatPattern(pattern, Object.fromEntries(places), []);
  }

  private value(value: Value): FluentValue {
    return typeof value === "number" ? new Count(value, this.format.count(value)) : this.part(value);
  }

  /** A string within a text is a name: in any script, it does not disturb the adjacent text. */
  private part(text: Text): string {
    return typeof text === "string" ? isolated(text) : this.render(text);
  }
}

/** Some signs are not separated from their number by a line break. */
function typeset(source: string): string {
  return source
    .replaceAll(/(?<=[ (])k = (?=\d)/g, "k\u00a0=\u00a0")
    .replaceAll(/ rms\b/g, "\u00a0rms")
    .replaceAll(/(?<=\}) ×/g, "\u00a0×")
    .replaceAll(/([×Ø]) (?=\{)/g, "$1\u00a0");
}
