import { expect, test } from "vitest";

import type { Action, Finding } from "../api/wire";
import { message, quantity, type Text } from "../messages/text";
import { localized } from "../state/localized";
import { newFindings } from "./findings";

const finding = (text: Text) => ({ quality: "bad", text, remedy: "", pose: null }) as unknown as Finding;
const action = (why_not: Text, enabled = false) => ({ enabled, why_not }) as unknown as Action;
const sentence = (text: Text): Text => ({ message_id: "sentence", values: { text } });
const off = (by: number): Text => message("ui-limit-value", { value: quantity(by, "µm") });

test("a finding is displayed once, whatever its form and its numbers elsewhere", () => {
  const findings = localized([finding(sentence(off(3))), finding(message("ui-open"))]);
  expect(newFindings(findings, localized([action(off(3.5))]))).toEqual([findings[1]]);
  expect(newFindings(findings, localized([action(off(3.5), true)]))).toEqual(findings);
  expect(newFindings(findings, [], [sentence(off(1)), ""])).toEqual([findings[1]]);
});
