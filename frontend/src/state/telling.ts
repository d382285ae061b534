import { useSyncExternalStore } from "react";

import type { Told } from "../api/watchTypes";
import { said, t, words } from "./language";
import { getState, subscribe } from "./store";

const KEY = "crenel-telling";
const TITLES: Record<Told["kind"], string> = { done: words("done"), fault: words("fault"), due: words("due"), test: words("test") };

type Telling = "on" | "off" | "denied" | "impossible";

const listeners = new Set<() => void>();
let seen: string | null = null;

function changed(): void {
  for (const listener of listeners) listener();
}

function telling(): Telling {
  if (!("Notification" in window) || !window.isSecureContext) return "impossible";
  if (Notification.permission === "denied") return "denied";
  return Notification.permission === "granted" && localStorage.getItem(KEY) === "1" ? "on" : "off";
}

/** Asked for by a press, and by nothing else. */
export async function askToTell(): Promise<void> {
  if ((await Notification.requestPermission()) === "granted") localStorage.setItem(KEY, "1");
  changed();
}

export function stopTelling(): void {
  localStorage.removeItem(KEY);
  changed();
}

export function useTelling(): Telling {
  return useSyncExternalStore((listener) => {
    listeners.add(listener);
    return () => listeners.delete(listener);
  }, telling);
}

/** Shows each notice once; the one that a new connection begins with is an old one. */
export function startTelling(): void {
  subscribe(() => {
    const { told, connection, report } = getState();
    if (connection !== "live" || !report) return;
    const key = told ? `${told.instance} ${told.number}` : "";
    if (seen === null || key === seen) {
      seen ??= key;
      return;
    }
    seen = key;
    if (told && telling() === "on") {
      new Notification(`${told.name}: ${t(TITLES[told.kind])}`, { body: said(told.text), tag: key });
    }
  });
}
