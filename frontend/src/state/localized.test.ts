import { afterEach, expect, test } from "vitest";

import { message, quantity } from "../messages/text";
import { chooseLanguage } from "./language";
import { asSent, localized } from "./localized";
import { chooseUnits } from "./units";

afterEach(async () => {
  await chooseLanguage("en");
  chooseUnits("metric");
});

const FLOW = {
  title: message("ui-calibrate"),
  name: "R2",
  outline: [[1, 2, 3, 4]],
  steps: [{ id: "touch", title: message("ui-n-points", { n: 2 }) }],
  number: { label: "x", value: 1, unit: "mm", decimals: 0, quality: "good", note: quantity(25.4, "mm") },
  actions: [{ label: message("ui-open"), args: { label: message("ui-open") } }],
  nothing: null,
};

test("every message is put into words, wherever it is; the rest stays", async () => {
  await chooseLanguage("de");
  const flow = localized(FLOW) as unknown as Record<string, unknown>;
  expect(flow).toMatchObject({ title: "Kalibrieren", name: "R2", nothing: null, steps: [{ title: "2 Punkte" }] });
  expect(flow.outline).toBe(FLOW.outline);
  expect(flow.number).toMatchObject({ value: 1, note: "25\u00a0mm" });
  expect(flow.actions).toEqual([{ label: "Öffnen", args: FLOW.actions[0]?.args }]);
});

test("the same gives the same, until language or units change", async () => {
  const first = localized(FLOW);
  expect(localized(FLOW)).toBe(first);
  expect(localized({ a: FLOW.steps }).a).toBe(first.steps);
  chooseUnits("inch");
  expect(localized(FLOW)).not.toBe(first);
  expect(localized(FLOW).number.note).toBe("1.00\u00a0in");
  await chooseLanguage("de");
  expect(localized(FLOW).number.note).toBe("1,00\u00a0in");
});

test("what has no message in it is given back itself, and the original can be had again", () => {
  const plain = { a: [{ b: "c" }], d: 1 };
  expect(localized(plain)).toBe(plain);
  expect(asSent(localized(FLOW))).toBe(FLOW);
  expect(asSent(localized(FLOW).steps)).toBe(FLOW.steps);
  expect(asSent(plain)).toBe(plain);
  expect([localized("text"), localized(7), localized(null)]).toEqual(["text", 7, null]);
});

test("English with its message next to it is localized, and stays where the message is not known", async () => {
  await chooseLanguage("de");
  const file = {
    title: "Open",
    title_message: message("ui-open"),
    text: "Of a newer station",
    text_message: { message_id: "of-a-newer-station", values: {} },
    notes: ["Open", "Older"],
    notes_message: [message("ui-open"), null],
    reason: "No data",
    reason_message: null,
  };
  expect(localized(file)).toMatchObject({
    title: "Öffnen",
    text: "Of a newer station",
    notes: ["Öffnen", "Older"],
    reason: "No data",
  });
});
