/** The station's sentences in another language. The Python side is app/strings/sentences.py. */

export type Strings = Readonly<Record<string, string>>;
export type Values = Readonly<Record<string, string | number>>;

interface Template {
  pattern: RegExp;
  names: string[];
  other: string;
}

const PLACE = /\{(\w+)\}/g;
const SENTENCE_END = /(?<=[.?]) (?=[A-Z])/;
/** Where a text is put together of others, the loosest joint first. */
const JOINTS = [SENTENCE_END, /( · )/, /(: )/, /(; )/, /(, )/];
const HELD = 2000;

/** The placeholders replaced by their values; one without a value stays. */
export function filled(text: string, values: Values = {}): string {
  return text.replace(PLACE, (place, name: string) => String(values[name] ?? place));
}

/**
 * Ready English sentences by the templates they were made of. A sentence is looked up as it is,
 * then by the templates with placeholders, then in parts; what a placeholder caught is looked up
 * in turn. What is not known stays as it is.
 */
export class Sentences {
  private readonly strings: Strings;
  private readonly templates = new Map<string, Template[]>();
  private readonly held = new Map<string, string>();

  constructor(strings: Strings) {
    this.strings = strings;
    const open = Object.keys(strings).filter((text) => text.includes("{"));
    // the more a template says itself, the better it fits
    const said = (text: string) => text.replace(PLACE, "").length;
    for (const text of open.sort((a, b) => said(b) - said(a))) {
      const key = keyOf(text);
      this.templates.set(key, [...(this.templates.get(key) ?? []), template(text, strings[text] ?? text)]);
    }
  }

  said(text: string): string {
    let said = this.held.get(text);
    if (said === undefined) {
      said = this.known(text) ?? text;
      if (this.held.size >= HELD) this.held.clear();
      this.held.set(text, said);
    }
    return said;
  }

  private known(text: string): string | null {
    if (!/\p{L}{2}/u.test(text)) return null;
    return this.whole(text) ?? this.parts(text);
  }

  /** As it is, with or without its full stop, and with its first letter either way. */
  private whole(text: string): string | null {
    const found = this.one(text);
    if (found !== null) return found;
    const stop = text.endsWith(".");
    const other = this.one(stop ? text.slice(0, -1) : `${text}.`);
    if (other !== null) return stop ? `${other}.` : other.replace(/\.$/, "");
    const first = text.charAt(0);
    const lower = first.toLowerCase();
    if (first === lower) return this.strings[first.toUpperCase() + text.slice(1)] ?? null;
    const begun = this.strings[lower + text.slice(1)];
    return begun === undefined ? null : begun.charAt(0).toUpperCase() + begun.slice(1);
  }

  private one(text: string): string | null {
    return this.strings[text] ?? this.fitted(text);
  }

  private fitted(text: string): string | null {
    const words = text.split(" ");
    for (const key of [`${words[0]} `, ` ${words.at(-1)}`, ""]) {
      for (const { pattern, names, other } of this.templates.get(key) ?? []) {
        const caught = pattern.exec(text)?.slice(1);
        // a placeholder never stands for the end of one sentence and the beginning of the next
        if (!caught || caught.some((part) => SENTENCE_END.test(part))) continue;
        return filled(other, Object.fromEntries(names.map((name, i) => [name, this.said(caught[i] ?? "")])));
      }
    }
    return null;
  }

  private parts(text: string): string | null {
    for (const joint of JOINTS) {
      const pieces = text.split(joint);
      if (pieces.length === 1) continue;
      const said = pieces.map((piece) => this.said(piece));
      if (said.some((piece, i) => piece !== pieces[i])) return said.join(joint === SENTENCE_END ? " " : "");
    }
    return null;
  }
}

/** What a text must begin or end with to fit: a whole word of the template, where it has one there. */
function keyOf(text: string): string {
  const words = text.split(" ");
  const [first = "", last = ""] = [words[0], words.at(-1)];
  if (words.length > 1 && !first.includes("{")) return `${first} `;
  if (words.length > 1 && !last.includes("{")) return ` ${last}`;
  return "";
}

function template(text: string, other: string): Template {
  const names = Array.from(text.matchAll(PLACE), (place) => place[1] ?? "");
  const literals = text.split(/\{\w+\}/).map((literal) => literal.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"));
  return { pattern: new RegExp(`^${literals.join("(.*?)")}$`, "su"), names, other };
}
