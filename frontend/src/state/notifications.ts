import { useSyncExternalStore } from "react";
import type { Notice } from "../api/wire";
import type { PlainId } from "../messages/text";
import { t } from "./language";
import { localized } from "./localized";
import { getState, subscribe } from "./store";

const KEY = "crenel-telling";
const TITLES: Record<Notice["kind"], PlainId> = {
  done: "ui-done",
  fault: "ui-fault",
  due: "ui-due",
  test: "ui-test-lowercase",
};

type NotificationState = "on" | "off" | "denied" | "impossible";

const listeners = new Set<() => void>();
let last: string | null = null;

function changed(): void {
  for (const listener of listeners) listener();
}

function notificationState(): NotificationState {
  if (!("Notification" in window) || !window.isSecureContext) return "impossible";
  if (Notification.permission === "denied") return "denied";
  return Notification.permission === "granted" && localStorage.getItem(KEY) === "1" ? "on" : "off";
}

/** Only on a press of the user. */
export async function askForNotifications(): Promise<void> {
  if ((await Notification.requestPermission()) === "granted") localStorage.setItem(KEY, "1");
  changed();
}

export function stopNotifications(): void {
  localStorage.removeItem(KEY);
  changed();
}

export function useNotificationState(): NotificationState {
  return useSyncExternalStore((listener) => {
    listeners.add(listener);
    return () => listeners.delete(listener);
  }, notificationState);
}

/** Shows each notice once; the first one of a new connection is old. */
export function startNotifications(): void {
  subscribe(() => {
    const { notice, connection, report } = getState();
    if (connection !== "live" || !report) return;
    const key = notice ? `${notice.instance} ${notice.number}` : "";
    if (last === null || key === last) {
      last ??= key;
      return;
    }
    last = key;
    if (notice && notificationState() === "on") {
      new Notification(`${notice.name}: ${t(TITLES[notice.kind])}`, { body: localized(notice).text, tag: key });
    }
  });
}
