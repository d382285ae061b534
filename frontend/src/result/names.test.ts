import { afterEach, expect, test } from "vitest";

import { chooseLanguage } from "../state/language";
import { cornerName } from "./names";

afterEach(() => chooseLanguage("en"));

test("corners have the names of the trade", async () => {
  const corners = ["crest:2:L:front", "base:R:back", "corner 3,2", "something else"];
  expect(corners.map(cornerName)).toEqual(["crest 3, front left", "base, back right", "corner 3,2", "something else"]);
  await chooseLanguage("de");
  expect(corners.slice(0, 3).map(cornerName)).toEqual([
    "Zinnenoberseite 3, vorn links",
    "Grundfläche, hinten rechts",
    "Ecke 3,2",
  ]);
});
