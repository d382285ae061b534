import { useSyncExternalStore } from "react";

const listeners = new Set<() => void>();
let opened = false;

/** Opens or closes the dialog of the keys and the tour. */
export function showHelp(now: boolean): void {
  opened = now;
  for (const listener of listeners) listener();
}

export function useHelp(): boolean {
  return useSyncExternalStore(
    (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    () => opened,
  );
}
