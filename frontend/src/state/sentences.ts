/** The station's sentences in another language. The Python side is app/strings/sentences.py. */

export type Strings = Readonly<Record<string, string>>;
export type Values = Readonly<Record<string, string | number>>;

interface Template {
  pattern: RegExp;
  names: string[];
  other: string;
}

/** In the other language, and how many letters of it are not. */
interface Said {
  text: string;
  left: number;
}

const PLACE = /\{(\w+)\}/g;
const SENTENCE_END = /(?<=[.?]) (?=[A-Z])/;
/** Where a text is put together of others, the loosest joint first. */
const JOINTS = [new RegExp(SENTENCE_END, "g"), / · /g, /: /g, /; /g, /, /g];
const MOST_JOINTS = 8;
const LOOSE = /^([ ,;·]*)(.*?)([ ,;·]*)$/s;
const UNITS = new Set(["mm", "µm", "µs", "ms", "ns", "px", "rms", "Hz", "fps", "GB", "MB", "UTC", "rad", "min"]);
const HELD = 2000;
/** Pieces of one text; the longest of the station's own have half of it. */
const MOST_LOOKED_UP = 400;

/** The placeholders replaced by their values; one without a value stays. */
export function filled(text: string, values: Values = {}): string {
  return text.replace(PLACE, (place, name: string) => String(values[name] ?? place));
}

/**
 * Ready English sentences by the templates they were made of. A sentence is looked up as it is,
 * then by the templates with placeholders and in parts, whichever leaves least in English; what a
 * placeholder caught is looked up in turn. What is not known stays as it is.
 */
export class Sentences {
  private readonly strings: Strings;
  private readonly templates = new Map<string, Template[]>();
  private readonly held = new Map<string, Said>();
  private left = 0;

  constructor(strings: Strings) {
    this.strings = strings;
    const open = Object.keys(strings).filter((text) => text.includes("{"));
    // of two that fit alike, the one that says more itself
    const own = (text: string) => text.replace(PLACE, "").length;
    for (const text of open.sort((a, b) => own(b) - own(a))) {
      const key = keyOf(text);
      this.templates.set(key, [...(this.templates.get(key) ?? []), template(text, strings[text] ?? text)]);
    }
  }

  /** Beyond so many pieces the rest of a text stays as it is: they grow as a power of its length. */
  said(text: string, most = MOST_LOOKED_UP): string {
    this.left = most;
    return this.best(text).text;
  }

  private best(text: string): Said {
    let best = this.held.get(text);
    if (best === undefined) {
      this.left -= 1;
      best = this.left < 0 ? { text, left: letters(text) } : this.found(text);
      if (this.held.size >= HELD) this.held.clear();
      this.held.set(text, best);
    }
    return best;
  }

  private found(text: string): Said {
    const [, before = "", core = "", after = ""] = LOOSE.exec(text) ?? [];
    if (core && core !== text) {
      // it goes on with a sentence: what joins it stays
      const said = this.best(core);
      return { text: before + said.text + after, left: said.left };
    }
    let best = { text, left: letters(text) };
    // what has lines is of the program's log
    if (best.left === 0 || text.includes("\n")) return best;
    for (const said of this.ways(text)) {
      if (said.left < best.left) best = said;
      if (best.left === 0) break;
    }
    return best;
  }

  /** With or without its full stop, with its first letter either way, and in parts. */
  private *ways(text: string): Generator<Said> {
    yield* this.eitherCase(text);
    const stop = text.endsWith(".");
    for (const { text: said, left } of this.eitherCase(stop ? text.slice(0, -1) : `${text}.`)) {
      yield { text: stop ? `${said}.` : said.replace(/\.$/, ""), left };
    }
    yield* this.parts(text);
  }

  private *eitherCase(text: string): Generator<Said> {
    const first = text.charAt(0);
    const small = first === first.toLowerCase();
    const other = (small ? first.toUpperCase() : first.toLowerCase()) + text.slice(1);
    /* A name known whole is not put together of its words: "Contact points" is no "{n} points". */
    const whole = this.strings[text] === undefined && this.strings[other] !== undefined;
    if (!whole) yield* this.one(text);
    if (other === text) return;
    for (const { text: said, left } of this.one(other)) {
      yield { text: small ? said : said.charAt(0).toUpperCase() + said.slice(1), left };
    }
    if (whole) yield* this.one(text);
  }

  private *one(text: string): Generator<Said> {
    const exact = this.strings[text];
    if (exact !== undefined) yield { text: exact, left: 0 };
    const words = text.split(" ");
    for (const key of [`${words[0]} `, ` ${words.at(-1)}`, ""]) {
      for (const { pattern, names, other } of this.templates.get(key) ?? []) {
        const caught = pattern.exec(text)?.slice(1);
        // a placeholder never stands for the end of one sentence and the beginning of the next
        if (!caught || caught.some((part) => SENTENCE_END.test(part))) continue;
        const said = caught.map((part) => this.best(part));
        const values = Object.fromEntries(names.map((name, i) => [name, said[i]?.text ?? ""]));
        yield { text: filled(other, values), left: said.reduce((sum, part) => sum + part.left, 0) };
      }
    }
  }

  /** Parted at each joint in turn, where there are few; else at all of a kind at once. */
  private *parts(text: string): Generator<Said> {
    for (const joint of JOINTS) {
      const found = Array.from(text.matchAll(joint));
      const [first] = found;
      if (first && found.length > MOST_JOINTS) yield this.together(text.split(joint), first[0]);
      else for (const at of found) yield this.together([text.slice(0, at.index), text.slice(at.index + at[0].length)], at[0]);
    }
  }

  private together(pieces: string[], joint: string): Said {
    const said = pieces.map((piece) => this.best(piece));
    return { text: said.map((part) => part.text).join(joint), left: said.reduce((sum, part) => sum + part.left, 0) };
  }
}

/** How much of a text is words; units and what is all capitals are none. */
function letters(text: string): number {
  return Array.from(text.matchAll(/\p{L}{2,}/gu), ([word]) => (UNITS.has(word) || word === word.toUpperCase() ? 0 : word.length)).reduce((sum, n) => sum + n, 0);
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
