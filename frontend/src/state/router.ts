import { useSyncExternalStore } from "react";

export const PAGES = ["home", "calibrate", "verify", "scan", "arm", "records", "settings", "people"] as const;
export type Page = (typeof PAGES)[number];

export const TITLES: Record<Page, string> = {
  home: "Home",
  calibrate: "Calibrate",
  verify: "Verify",
  scan: "Scan",
  arm: "Arm check",
  records: "Records",
  settings: "Settings",
  people: "People",
};

const listeners = new Set<() => void>();

function current(): Page {
  const name = window.location.pathname.replace(/^\/+|\/+$/g, "");
  return PAGES.find((page) => page === name) ?? "home";
}

export function pathOf(page: Page): string {
  return page === "home" ? "/" : `/${page}`;
}

export function go(page: Page): void {
  if (current() === page) return;
  window.history.pushState(null, "", pathOf(page));
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
