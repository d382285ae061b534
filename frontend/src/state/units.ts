import { useSyncExternalStore } from "react";

/** The units of length, chosen by each browser for itself. */
export type Units = "metric" | "inch";

const KEY = "crenel-units";
const listeners = new Set<() => void>();
let chosen: Units = window.localStorage.getItem(KEY) === "inch" ? "inch" : "metric";

export function units(): Units {
  return chosen;
}

export function chooseUnits(now: Units): void {
  chosen = now;
  window.localStorage.setItem(KEY, now);
  for (const listener of listeners) listener();
}

export function useUnits(): Units {
  return useSyncExternalStore((listener) => {
    listeners.add(listener);
    return () => listeners.delete(listener);
  }, units);
}
