import { expect, test } from "vitest";

import { mentions, quantity, type Text } from "./text";

const silent = (seconds: number): Text => ({ message_id: "no-data", values: { silent: quantity(seconds, "s", 1) } });
const sentence = (text: Text): Text => ({ message_id: "sentence", values: { text } });

test("a message is found again in another, whatever its numbers", () => {
  expect(mentions(sentence(silent(3)), silent(4))).toBe(true);
  expect(mentions(silent(3), sentence(silent(4)))).toBe(true);
  expect(mentions({ items: [sentence(silent(3)), "Check it."], separator: " " }, silent(5))).toBe(true);
});

test("another message, or another name, is not", () => {
  expect(mentions(sentence(silent(3)), { message_id: "off", values: {} })).toBe(false);
  expect(mentions(sentence("R2"), "R2")).toBe(true);
  expect(mentions("R2", "R3")).toBe(false);
  expect(mentions("R2", silent(3))).toBe(false);
});
