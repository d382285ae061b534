import { useSyncExternalStore } from "react";
import type { PlainId } from "../messages/text";
import { addressOf, stationPath } from "./base";

export const PAGES = [
  "home",
  "calibrate",
  "verify",
  "performance",
  "scan",
  "part",
  "arm",
  "records",
  "supervise",
  "health",
  "settings",
  "datasheets",
  "devices",
  "people",
] as const;
/** A page that is not in the menu: the Health page links to it. */
const REFERENCE = "docs";
export type Page = (typeof PAGES)[number] | typeof REFERENCE;

export const TITLES: Record<Page, PlainId> = {
  home: "ui-home",
  calibrate: "ui-calibrate",
  verify: "ui-verify",
  performance: "ui-performance",
  scan: "ui-scan",
  part: "ui-part-page",
  arm: "ui-arm-tip",
  records: "ui-records",
  supervise: "ui-supervise",
  health: "ui-health",
  settings: "ui-settings",
  datasheets: "ui-datasheets",
  devices: "ui-devices",
  people: "ui-people",
  docs: "ui-http-interface",
};

const listeners = new Set<() => void>();

function parts(): string[] {
  return stationPath().split("/").filter(Boolean);
}

function current(): Page {
  const name = parts()[0];
  return [...PAGES, REFERENCE].find((page): page is Page => page === name) ?? "home";
}

/** The item shown on a page, such as one of the records; empty for the page itself. */
function currentDetail(): string {
  return parts().slice(1).map(decodeURIComponent).join("/");
}

export function pathOf(page: Page, detail = ""): string {
  const path = addressOf(page === "home" ? "/" : page);
  return detail ? `${path}/${detail.split("/").map(encodeURIComponent).join("/")}` : path;
}

export function go(page: Page, detail = ""): void {
  if (current() === page && currentDetail() === detail) return;
  window.history.pushState(null, "", pathOf(page, detail));
  for (const listener of listeners) listener();
}

function subscribe(listener: () => void): () => void {
  listeners.add(listener);
  window.addEventListener("popstate", listener);
  return () => {
    listeners.delete(listener);
    window.removeEventListener("popstate", listener);
  };
}

export function usePage(): Page {
  return useSyncExternalStore(subscribe, current);
}

export function useDetail(): string {
  return useSyncExternalStore(subscribe, currentDetail);
}
