import type { Page } from "./router";
import { type Guide, type SessionView, useLive } from "./store";

const GUIDES: Partial<Record<Page, Guide>> = {
  calibrate: "flow",
  verify: "verify",
  performance: "performance",
  part: "parts",
  arm: "arm",
};

export function hasSession(page: Page): boolean {
  return page in GUIDES;
}

/** The guided session that a page displays; null on other pages, and before it is known. */
export function usePageSession(page: Page): SessionView | null {
  const guide = GUIDES[page];
  return useLive((s) => (guide ? s[guide] : null));
}
