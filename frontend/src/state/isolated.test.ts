import { expect, test } from "vitest";

import { isolated } from "./isolated";

const ARABIC = "ذراع القياس";

test("a name keeps what is around it in place, once", () => {
  expect(isolated("plain, Ø 3 µm and 臂")).toBe("plain, Ø 3 µm and 臂");
  expect(isolated(ARABIC)).toBe(`\u2068${ARABIC}\u2069`);
  expect(isolated(isolated(ARABIC))).toBe(isolated(ARABIC));
});

test("signs that turn the text become visible", () => {
  expect(isolated("scan \u202egnp.exe")).toContain("\ufffd");
  expect(isolated("a \u2069\u2067b")).toContain("a \ufffd\ufffdb");
});
