import { beforeAll, beforeEach, expect, test } from "vitest";

import { keysOf, SHORTCUTS, startShortcuts } from "./shortcuts";

const PLAIN = { key: "z", ctrlKey: false, metaKey: false, altKey: false, shiftKey: false };

test.each([
  [{ ctrlKey: true }, "Control+z"],
  [{ metaKey: true }, "Control+z"],
  [{ ctrlKey: true, key: "Z" }, "Control+z"],
  [{ ctrlKey: true, key: "ArrowUp" }, "Control+ArrowUp"],
  [{ ctrlKey: true, shiftKey: true }, ""],
  [{ ctrlKey: true, altKey: true }, ""],
  [{ shiftKey: true, key: "?" }, "?"],
  [{}, "z"],
])("%o is %s", (pressed, keys) => {
  expect(keysOf({ ...PLAIN, ...pressed })).toBe(keys);
});

test("no two shortcuts have the same keys", () => {
  const keys = Object.values(SHORTCUTS).map((shortcut) => shortcut.keys);
  expect(new Set(keys).size).toBe(keys.length);
});

const pressed: string[] = [];

beforeAll(startShortcuts);
beforeEach(() => {
  pressed.length = 0;
  document.body.innerHTML = `
    <button id="undo" aria-keyshortcuts="Control+z"></button>
    <button id="stop" aria-keyshortcuts="Control+."></button>
    <input id="field">`;
  for (const button of document.querySelectorAll("button")) {
    button.checkVisibility = () => true;
    button.addEventListener("click", () => pressed.push(button.id));
  }
});

function press(key: string, target: EventTarget, more = {}): void {
  target.dispatchEvent(new KeyboardEvent("keydown", { key, ctrlKey: true, bubbles: true, cancelable: true, ...more }));
}

test("the button that states the keys is pressed, once", () => {
  press("z", document.body);
  press("z", document.body, { repeat: true });
  press("y", document.body);
  expect(pressed).toEqual(["undo"]);
});

test("only Stop responds while something is typed or asked", () => {
  const field = document.getElementById("field") as HTMLInputElement;
  press("z", field);
  press(".", field);
  document.body.insertAdjacentHTML("beforeend", `<section aria-modal="true"></section>`);
  press("z", document.body);
  press(".", document.body);
  expect(pressed).toEqual(["stop", "stop"]);
});
