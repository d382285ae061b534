import { useSyncExternalStore } from "react";

import { figures } from "../parts/figures";
import { inUnits } from "../parts/lengths";
import { isolated, withIsolated } from "./isolated";
import { filled, Sentences, type Strings, type Values } from "./sentences";

const KEY = "crenel-language";
const ENGLISH = "en";
const FEW_LOOKED_UP = 25;
const LONGEST_LOOKED_UP = 160;
/** One file a language, read only once its language is chosen. */
const FILES = import.meta.glob<Strings>(["../../../app/strings/*.json", "!../../../app/strings/en.json"], { import: "default" });
const READ = new Map(Object.entries(FILES).map(([path, read]) => [path.replace(/^.*\/|\.json$/g, ""), read]));

/** All languages there are, by their codes. */
export const LANGUAGES: readonly string[] = [ENGLISH, ...READ.keys()];

/** A link may ask for a language; read before anything tidies the address. */
const ASKED = new URLSearchParams(window.location.search).get("lang");

let language = ENGLISH;
let strings: Strings = {};
let sentences: Sentences | null = null;
/** Counts up with each change of how sentences are said; 0 while they are said as they come. */
let changes = 0;
const listeners = new Set<() => void>();

/** A language's name in itself. */
export function nameOf(code: string): string {
  return new Intl.DisplayNames([code], { type: "language" }).of(code) ?? code;
}

/** The browser's own words. In English they are the key and are not looked up. */
export function t(text: string, values: Values = {}): string {
  const named = Object.entries(values).map(([name, value]) => [name, typeof value === "string" ? isolated(value) : value]);
  return filled(strings[text] ?? text, Object.fromEntries(named) as Values);
}

/** One of two wordings by a count, which both may name as {n}. */
export function counted(n: number, one: string, more: string, values: Values = {}): string {
  return t(n === 1 ? one : more, { n: figures(n), ...values });
}

/** Words that are told apart from where they are shown; `t` or `said` is for where they are. */
export function words(text: string): string {
  return text;
}

/** A sentence that the station said, in this browser's language and units; what is not known stays as it is. */
export function said(text: string): string {
  return withIsolated(inUnits(sentences ? sentences.said(text) : text));
}

/** As above, of what comes from elsewhere: it costs a bounded time, whatever it is. */
export function saidElsewhere(text: string): string {
  if (!sentences || text.length > LONGEST_LOOKED_UP) return withIsolated(inUnits(text));
  return withIsolated(inUnits(sentences.said(text, FEW_LOOKED_UP)));
}

/** Which wording `said` gives: another number, another wording; 0 is the station's own. */
export function heardSince(): number {
  return changes;
}

/** The language now; a component that asks renders again when it changes. */
export function useLanguage(): string {
  return useSyncExternalStore(
    (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    () => language,
  );
}

/** As above, outside of components. */
export function languageNow(): string {
  return language;
}

/** Reads the language, shows it from now on, and keeps it for this browser. */
export async function chooseLanguage(code: string): Promise<void> {
  await show(code);
  localStorage.setItem(KEY, code);
}

/** Before the first paint: what the address asks for, what was chosen here, or the browser's own. */
export async function startLanguage(): Promise<void> {
  if (ASKED) window.history.replaceState(null, "", window.location.pathname + window.location.hash);
  if (ASKED && LANGUAGES.includes(ASKED)) return chooseLanguage(ASKED);
  const kept = localStorage.getItem(KEY);
  const wanted = [kept ?? "", ...navigator.languages.map((one) => one.slice(0, 2).toLowerCase())];
  await show(wanted.find((code) => LANGUAGES.includes(code)) ?? ENGLISH);
}

async function show(code: string): Promise<void> {
  try {
    strings = (await READ.get(code)?.()) ?? {};
  } catch {
    // the file did not come: English is better than no page
    code = ENGLISH;
    strings = {};
  }
  language = code;
  sentences = code === ENGLISH ? null : new Sentences(strings);
  if (sentences || changes) changes += 1;
  document.documentElement.lang = code;
  for (const listener of listeners) listener();
}
