import { afterEach, expect, test } from "vitest";

import type { DevicesView, DriverForm, OptionField } from "../api/wire";
import { chooseLanguage } from "../state/language";
import { driversOf, driverTitle, optionLabel } from "./names";

const form = (name: string, kind: "arm" | "sensor" = "sensor", alias = false): DriverForm => ({
  kind,
  name,
  alias,
  fields: [],
  problem: "",
});
const field = (key: string, unit: OptionField["unit"] = ""): OptionField => ({
  key,
  unit,
  kind: "text",
  choices: [],
  required: false,
  default: "",
  main: false,
  help: "",
});

afterEach(async () => {
  await chooseLanguage("en");
});

test("drivers are offered once, those of other packages last", () => {
  const drivers = [form("bench"), form("folder"), form("bridge", "arm"), form("opencv"), form("copy", "sensor", true)];
  const view = { drivers } as Partial<DevicesView> as DevicesView;
  expect(driversOf(view, "sensor").map((one) => one.name)).toEqual(["opencv", "folder", "bench"]);
});

test("a driver that is not known has its own name", () => {
  expect(driverTitle("bench")).toBe("bench");
  expect(driverTitle("folder")).toBe("Folder of pictures");
});

test("an option that is not known has the words of its key, without the unit", async () => {
  expect(optionLabel(field("settling_time_ms", "ms"))).toBe("Settling time");
  expect(optionLabel(field("axis_names"))).toBe("Axis names");
  expect(optionLabel(field("source"))).toBe("Camera number, device, address or file");
  await chooseLanguage("de");
  expect(optionLabel(field("source"))).toBe("Kameranummer, Gerät, Adresse oder Datei");
});
