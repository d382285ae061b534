import { afterEach, expect, test } from "vitest";

import type { OptionField } from "../api/wire";
import { chooseLanguage } from "../state/language";
import { choiceLabel, optionHelp } from "./optionTexts";

const field = (key: string, unit: OptionField["unit"] = "", help = ""): OptionField => ({
  key,
  unit,
  help,
  kind: "text",
  choices: [],
  required: false,
  default: "",
  main: false,
});
const offer = { choices: [], bounds: null, largest: "" };

afterEach(async () => {
  await chooseLanguage("en");
});

test("the values of a choice have words, unknown ones their own", async () => {
  expect(choiceLabel(field("line_rows"), "region")).toBe("first row of the region");
  expect(choiceLabel(field("mode"), "fast")).toBe("fast");
  await chooseLanguage("de");
  expect(choiceLabel(field("trigger_edge"), "rising")).toBe("steigend");
});

test("a field says what it takes, and what the device offers", () => {
  expect(optionHelp(field("region"), { ...offer, key: "region", largest: "0, 0, 640, 480" })).toBe(
    "x, y, width, height in pixels · at most 0, 0, 640, 480",
  );
  const rate = optionHelp(field("rate_hz", "Hz"), { ...offer, key: "rate_hz", bounds: [0.1, 1000] });
  expect(rate.replaceAll("\u202f", " ").replaceAll("\u00a0", " ")).toBe("0.10 Hz to 1000 Hz");
  expect(optionHelp(field("region", "", "Of the driver"), undefined)).toBe("Of the driver");
  expect(optionHelp(field("mode"), undefined)).toBe("");
});
