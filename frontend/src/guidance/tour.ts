import { useSyncExternalStore } from "react";
import type { PlainId } from "../messages/text";

/** What the tour shows: parts of the frame, which have the names as `data-part`. */
export const TOUR: readonly { part: string; title: PlainId; text: PlainId }[] = [
  { part: "card", title: "ui-tour-card", text: "ui-tour-card-text" },
  { part: "picture", title: "ui-tour-picture", text: "ui-tour-picture-text" },
  { part: "pages", title: "ui-tour-pages", text: "ui-tour-pages-text" },
  { part: "stop", title: "ui-tour-stop", text: "ui-tour-stop-text" },
  { part: "control", title: "ui-tour-control", text: "ui-tour-control-text" },
  { part: "help", title: "ui-tour-help", text: "ui-tour-help-text" },
];

const KEY = "crenel-tour";
const LEFT = "left";
const listeners = new Set<() => void>();
/** The part that is shown; null once the tour was left, in this browser for good. */
let part: number | null = window.localStorage.getItem(KEY) === LEFT ? null : 0;

function show(now: number | null): void {
  part = now;
  if (now === null) window.localStorage.setItem(KEY, LEFT);
  for (const listener of listeners) listener();
}

export const startTour = () => show(0);
export const leaveTour = () => show(null);
export const goOnWithTour = () => show(part === null || part + 1 === TOUR.length ? null : part + 1);

export function useTour(): number | null {
  return useSyncExternalStore(
    (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    () => part,
  );
}
