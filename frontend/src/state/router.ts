import { useSyncExternalStore } from "react";

import { words } from "./language";

export const PAGES = ["home", "calibrate", "verify", "scan", "arm", "records", "supervise", "health", "settings", "people"] as const;
export type Page = (typeof PAGES)[number];

export const TITLES: Record<Page, string> = {
  home: words("Home"),
  calibrate: words("Calibrate"),
  verify: words("Verify"),
  scan: words("Scan"),
  arm: words("Arm & tip"),
  records: words("Records"),
  supervise: words("Supervise"),
  health: words("Health"),
  settings: words("Settings"),
  people: words("People"),
};

const listeners = new Set<() => void>();

function parts(): string[] {
  return window.location.pathname.split("/").filter(Boolean);
}

function current(): Page {
  const name = parts()[0];
  return PAGES.find((page) => page === name) ?? "home";
}

/** What of a page is looked at, such as one of the records; empty for the page as a whole. */
function currentDetail(): string {
  return parts().slice(1).map(decodeURIComponent).join("/");
}

export function pathOf(page: Page, detail = ""): string {
  const path = page === "home" ? "/" : `/${page}`;
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
