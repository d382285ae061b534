import { afterEach, expect, test } from "vitest";

import { chooseLanguage, currentLanguage, LANGUAGES, nameOf, startLanguage, t, word } from "./language";

afterEach(async () => {
  await chooseLanguage("en");
  localStorage.clear();
});

test("a language is loaded when it is chosen, and remembered", async () => {
  expect(LANGUAGES.slice(0, 2)).toEqual(["en", "de"]);
  expect(t("ui-n-points", { n: 1 })).toBe("1 point");
  await chooseLanguage("de");
  expect([t("ui-n-points", { n: 1 }), word("front"), word("R2")]).toEqual(["1 Punkt", "Vorderseite", "R2"]);
  expect([document.documentElement.lang, nameOf("de"), localStorage.getItem("crenel-language")]).toEqual([
    "de",
    "Deutsch",
    "de",
  ]);
  await chooseLanguage("en");
  await startLanguage();
  expect(currentLanguage()).toBe("en");
});

test("a language that is not there is English", async () => {
  localStorage.setItem("crenel-language", "xx");
  await startLanguage();
  expect(currentLanguage()).toBe("en");
});
