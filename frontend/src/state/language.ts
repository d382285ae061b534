import { useSyncExternalStore } from "react";
import { chooseDecimalSign, figures, plainFigures } from "../controls/figures";
import { displayed } from "../controls/lengths";
import { Catalogue, type NumberFormat } from "../messages/catalogue";
import english from "../messages/collected/en.txt?raw";
import type { MessageId, Text, Value, Values } from "../messages/text";

const KEY = "crenel-language";
const ENGLISH = "en";
/** All texts of a language; those of another than English are loaded when it is chosen. */
const OTHERS = import.meta.glob<string>(["../messages/collected/*.txt", "!../messages/collected/en.txt"], {
  query: "?raw",
  import: "default",
});

/** All available languages, by their codes. */
export const LANGUAGES: readonly string[] = [
  ENGLISH,
  ...Object.keys(OTHERS).map((path) => path.replace(/^.*\/|\.txt$/g, "")),
];

/** A link may choose a language; read before the address is cleaned up. */
const REQUESTED = new URLSearchParams(window.location.search).get("lang");

const DISPLAY: NumberFormat = { quantity: displayed, count: figures };
const FILE: NumberFormat = {
  quantity: ({ value, unit, decimals }) => [plainFigures(value, decimals), unit].filter(Boolean).join(" "),
  count: String,
};
const ENGLISH_CATALOGUE = new Catalogue(ENGLISH, english, DISPLAY);
const FILE_CATALOGUE = new Catalogue(ENGLISH, english, FILE);

let language = ENGLISH;
let catalogue = ENGLISH_CATALOGUE;
const listeners = new Set<() => void>();

/** The name of a language in that language. */
export function nameOf(code: string): string {
  return new Intl.DisplayNames([code], { type: "language" }).of(code) ?? code;
}

/** One of the client's own texts. */
export function t<Id extends MessageId>(id: Id, ...[values]: Values<Id>): string {
  return catalogue.message(id, values ?? {});
}

/** A text in this browser's language and units. */
export function render(text: Text): string {
  return catalogue.render(text);
}

/** The same in English, with mm and µm, for files. */
export function renderEnglish(text: Text): string {
  return FILE_CATALOGUE.render(text);
}

/** Whether the language files have all messages of a text. */
export function isKnown(text: Value): boolean {
  return ENGLISH_CATALOGUE.knows(text);
}

/** The name of a word that the station sends in English: `front`, `left`. */
export function wordText(term: string): Text {
  const text = { message_id: `word-${term.replaceAll(" ", "-")}`, values: {} };
  return isKnown(text) ? text : term;
}

/** The same in this browser's language. */
export function word(term: string): string {
  return render(wordText(term));
}

/** The current language; a component that uses it re-renders when it changes. */
export function useLanguage(): string {
  return useSyncExternalStore(
    (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    () => language,
  );
}

/** As above, outside components. */
export function currentLanguage(): string {
  return language;
}

/** Loads the language, uses it from now on, and remembers it for this browser. */
export async function chooseLanguage(code: string): Promise<void> {
  await use(code);
  localStorage.setItem(KEY, code);
}

/** Before the first paint: the language in the address, the chosen one, or the browser's own. */
export async function startLanguage(): Promise<void> {
  if (REQUESTED) window.history.replaceState(null, "", window.location.pathname + window.location.hash);
  if (REQUESTED && LANGUAGES.includes(REQUESTED)) return chooseLanguage(REQUESTED);
  const chosen = localStorage.getItem(KEY);
  const wanted = [chosen ?? "", ...navigator.languages.map((one) => one.slice(0, 2).toLowerCase())];
  await use(wanted.find((code) => LANGUAGES.includes(code)) ?? ENGLISH);
}

async function use(code: string): Promise<void> {
  try {
    catalogue =
      code === ENGLISH ? ENGLISH_CATALOGUE : new Catalogue(code, await readTexts(code), DISPLAY, ENGLISH_CATALOGUE);
    language = code;
  } catch {
    // a file could not be loaded: English is better than no page
    catalogue = ENGLISH_CATALOGUE;
    language = ENGLISH;
  }
  chooseDecimalSign(language);
  document.documentElement.lang = language;
  for (const listener of listeners) listener();
}

function readTexts(code: string): Promise<string> {
  return OTHERS[`../messages/collected/${code}.txt`]?.() ?? Promise.resolve("");
}
