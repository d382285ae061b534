import { afterEach, expect, test } from "vitest";

import { chooseDecimalSign, figures } from "../controls/figures";
import { displayed } from "../controls/lengths";
import { chooseUnits } from "../state/units";
import { Catalogue } from "./catalogue";
import { quantity, signedQuantity, type Text } from "./text";

const ENGLISH = `
points = { $n ->
    [one] { $n } point
   *[other] { $n } points
  } on the { $face }
off = { $name } is { $by } off
whole = { CAPITAL(CLAUSE($what)) }, k = 2.
sized = { $x } × { $y }
only-english = English alone
`;
const GERMAN = `
points = { $n ->
    [one] { $n } Punkt
   *[other] { $n } Punkte
  } auf { $face }
off = { $name } liegt { $by } daneben
word-front = Vorderseite
`;
const FORMAT = { quantity: displayed, count: figures };
const english = new Catalogue("en", `${ENGLISH}\nword-front = front side`, FORMAT);
const german = new Catalogue("de", GERMAN, FORMAT, english);
const FRONT: Text = { message_id: "word-front", values: {} };
const HEBREW = "זרוע";

afterEach(() => {
  chooseUnits("metric");
  chooseDecimalSign("en");
});

test("a plural is chosen by its number, which is grouped", () => {
  const points = (n: number): Text => ({ message_id: "points", values: { n, face: FRONT } });
  expect(english.render(points(1))).toBe("1 point on the front side");
  expect(german.render(points(1))).toBe("1 Punkt auf Vorderseite");
  expect(german.render(points(0))).toBe("0 Punkte auf Vorderseite");
  expect(english.render(points(12345))).toBe("12\u2009345 points on the front side");
});

test("a quantity has the decimal sign of the language and the chosen unit", () => {
  const off = (by: Text): Text => ({ message_id: "off", values: { name: "A-7", by } });
  expect(english.render(off(quantity(0.125, "mm", 3)))).toBe("A-7 is 0.125\u00a0mm off");
  chooseDecimalSign("de");
  expect(german.render(off(signedQuantity(12.34, "µm", 1)))).toBe("A-7 liegt +12,3\u00a0µm daneben");
  chooseUnits("inch");
  expect(german.render(off(quantity(25.4, "mm", 1)))).toBe("A-7 liegt 1,000\u00a0in daneben");
  expect(german.render(off(quantity(254, "nm")))).toBe("A-7 liegt 10,00\u00a0µin daneben");
  expect(german.render(off(quantity(3.5, "°", 1)))).toBe("A-7 liegt 3,5° daneben");
  expect(german.render(off(quantity(2, "s")))).toBe("A-7 liegt 2\u00a0s daneben");
});

test("a sentence begins with a capital letter, but not the name of a file", () => {
  const whole = (what: string) => english.render({ message_id: "whole", values: { what } });
  expect(whole("the arm is still.")).toBe("The arm is still, k\u00a0=\u00a02.");
  expect(whole("gauges/plate.json is cut off")).toBe("gauges/plate.json is cut off, k\u00a0=\u00a02.");
});

test("what is no number is a dash, in both units", () => {
  const none = { ...quantity(0, "mm", 1), value: null as unknown as number };
  expect(english.render(none)).toBe("–\u00a0mm");
  chooseUnits("inch");
  expect(english.render(none)).toBe("–\u00a0in");
});

test("lists and nested messages are put into words", () => {
  const list: Text = { items: [FRONT, "R2", quantity(3, "px")], separator: " · " };
  expect(german.render(list)).toBe("Vorderseite · R2 · 3\u00a0px");
  expect(english.render({ message_id: "whole", values: { what: { items: [FRONT, "x."], separator: ", " } } })).toBe(
    "Front side, x, k\u00a0=\u00a02.",
  );
});

test("what a language lacks is in English, and an unknown id stands for itself", () => {
  expect(german.render({ message_id: "only-english", values: {} })).toBe("English alone");
  expect(german.render({ message_id: "nothing-of-this", values: {} })).toBe("nothing-of-this");
  expect(german.knows({ message_id: "only-english", values: {} })).toBe(true);
  expect(german.knows({ message_id: "off", values: { name: { message_id: "newer", values: {} }, by: 1 } })).toBe(false);
  expect(german.knows({ items: ["a", { message_id: "newer", values: {} }], separator: "" })).toBe(false);
});

test("a name from right to left leaves the text around it in place", () => {
  const off: Text = { message_id: "off", values: { name: HEBREW, by: quantity(1, "px") } };
  expect(english.render(off)).toBe(`\u2068${HEBREW}\u2069 is 1\u00a0px off`);
  expect(english.render({ items: [HEBREW, "b"], separator: ", " })).toBe(`\u2068${HEBREW}\u2069, b`);
  expect(english.render({ message_id: "off", values: { name: "a\u202eb", by: "c" } })).toBe(
    "\u2068a\ufffdb\u2069 is c off",
  );
  expect(english.render(HEBREW)).toBe(HEBREW);
});
