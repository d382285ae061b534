import { expect, test } from "vitest";

import { addressOf, BASE, proxyFault, stationPath } from "./base";

test("without a sub-path, addresses are paths of the station", () => {
  expect(addressOf("/api/session")).toBe("/api/session");
  expect(stationPath()).toBe(window.location.pathname);
});

test.each([
  [BASE.href, null],
  ["", null],
  [`http://upstream:8000${BASE.pathname}`, "host"],
  [BASE.href.replace("http:", "https:"), "scheme"],
  [`${BASE.origin}/crenel/`, "sub-path"],
])("the station asked for as %s: %s", (asked, fault) => {
  expect(proxyFault(asked)).toBe(fault);
});
