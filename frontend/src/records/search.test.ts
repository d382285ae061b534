import { expect, test } from "vitest";

import { matches } from "./search";

test("a record is found by words of any of its texts", () => {
  const texts = ["Gehäuse links", "SN 0042", "Müller GmbH", "2026-11-30 09:45"];
  const found = ["", "  ", "gehäuse", "GEHAUSE 42", "mull 11-30", "links gmbh"].filter((one) => matches(one, texts));
  expect(found).toHaveLength(6);
  const missed = ["rechts", "links rechts", "43"].filter((one) => matches(one, texts));
  expect(missed).toHaveLength(0);
});
