import { expect, test } from "vitest";

import type { OptionField } from "../api/wire";
import { optionHelp } from "./optionTexts";

const field = (key: string, unit: OptionField["unit"] = "", help = ""): OptionField => ({
  key,
  label: key,
  unit,
  help,
  words: {},
  kind: "text",
  choices: [],
  required: false,
  default: "",
  main: false,
});
const offer = { choices: [], bounds: null, largest: "" };

test("a field says what it takes, and what the device offers", () => {
  const region = field("region", "", "x, y, width, height in pixels");
  expect(optionHelp(region, { ...offer, key: "region", largest: "0, 0, 640, 480" })).toBe(
    "x, y, width, height in pixels · at most 0, 0, 640, 480",
  );
  const rate = optionHelp(field("rate_hz", "Hz"), { ...offer, key: "rate_hz", bounds: [0.1, 1000] });
  expect(rate.replaceAll("\u202f", " ").replaceAll("\u00a0", " ")).toBe("0.10 Hz to 1000 Hz");
  expect(optionHelp(field("region", "", "Of the driver"), undefined)).toBe("Of the driver");
  expect(optionHelp(field("mode"), undefined)).toBe("");
});
