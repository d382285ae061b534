import { t } from "../state/language";
import { ask } from "./commands";
import { drop, get, post } from "./http";
import type { AccessTokenSummary, BackupState, Notifications } from "./wire";

export const startBackup = () => ask(() => post<BackupState>("/api/backup"), t("ui-no-backup-was-started"));

export interface NotificationsChange {
  url: string;
  /** Null keeps it, an empty string removes it. */
  secret: string | null;
  done: boolean;
  fault: boolean;
  due: boolean;
}

export const changeNotifications = (change: NotificationsChange) =>
  ask(() => post<Notifications>("/api/notifications", change), t("ui-the-notifications-were-not-changed"));

export const tryNotifications = () =>
  ask(() => post<Notifications>("/api/notifications/test"), t("ui-nothing-was-sent"));

export const readNotifications = () =>
  ask(() => get<Notifications>("/api/notifications"), t("ui-result-test-message-unknown"));

/** The new token, which is shown only once; empty if it was not created. */
export async function addMetricsToken(name: string): Promise<string> {
  const made = await ask(() => post<AccessTokenSummary>("/api/tokens", { name }), t("ui-the-token-was-not-created"));
  return made?.token ?? "";
}

export const removeMetricsToken = (id: string) =>
  ask(() => drop(`/api/tokens/${id}`), t("ui-the-token-may-still-be-valid"));
