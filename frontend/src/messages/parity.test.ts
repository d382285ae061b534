/** The browser and the station render a message identically; run by tests/frontend. */

import { readFileSync } from "node:fs";

import { expect, test } from "vitest";

import { chooseDecimalSign } from "../controls/figures";
import { displayed } from "../controls/lengths";
import { Catalogue } from "./catalogue";
import type { Text } from "./text";

/** A file of the station's renderings, if its tests provide one. */
const path = process.env.CRENEL_RENDERINGS;
interface Rendering {
  text: Text;
  words: string;
}

test.runIf(path)("every message of the station reads alike in both", () => {
  const files = JSON.parse(readFileSync(path ?? "", "utf8")) as Record<string, { source: string; cases: Rendering[] }>;
  for (const [language, { source, cases }] of Object.entries(files)) {
    chooseDecimalSign(language);
    const catalogue = new Catalogue(language, source, { quantity: displayed, count: String });
    const different = cases.filter(({ text, words }) => plain(catalogue.render(text)) !== plain(words));
    expect(different.map(({ text, words }) => [text, words, catalogue.render(text)])).toEqual([]);
    expect(cases.length).toBeGreaterThan(1000);
  }
});

const ONE_WORD = [
  // tests and verifications, Home and Supervise, reports
  ["ui-uncertain", "ui-undecided", "undecided", "word-undecided"],
  ["ui-failed", "ui-failed-lowercase"],
  ["ui-passed", "ui-passed-lowercase"],
];

test.each(["en", "de"])("%s has one word for one result on every page", (language) => {
  const source = readFileSync(`src/messages/collected/${language}.txt`, "utf8");
  const catalogue = new Catalogue(language, source, { quantity: displayed, count: String });
  for (const ids of ONE_WORD) {
    expect(ids.filter((id) => !catalogue.has(id))).toEqual([]);
    expect(new Set(ids.map((id) => catalogue.message(id, {}).toLowerCase())).size, ids.join()).toBe(1);
  }
});

/** Non-breaking spaces are up to the browser. */
function plain(text: string): string {
  return text.replaceAll(/[\u00a0\u2009]/g, " ");
}
