import { clearBanner } from "../state/banner";
import { t } from "../state/language";
import { localized } from "../state/localized";
import { notifyOfError } from "./commands";
import { drop, get, post } from "./http";
import type { AccessTokenSummary, BackupState, Notifications } from "./wire";

async function done<T>(act: () => Promise<T | null>, whatWas: string): Promise<T | null> {
  try {
    const answer = await act();
    clearBanner();
    return localized(answer);
  } catch (error) {
    notifyOfError(error, whatWas);
    return null;
  }
}

export const startBackup = () => done(() => post<BackupState>("/api/backup"), t("ui-no-backup-was-started"));

export interface NotificationsChange {
  url: string;
  /** Null keeps it, an empty string removes it. */
  secret: string | null;
  done: boolean;
  fault: boolean;
  due: boolean;
}

export const changeNotifications = (change: NotificationsChange) =>
  done(() => post<Notifications>("/api/notifications", change), t("ui-the-notifications-were-not-changed"));

export const tryNotifications = () =>
  done(() => post<Notifications>("/api/notifications/test"), t("ui-nothing-was-sent"));

export const readNotifications = () =>
  done(() => get<Notifications>("/api/notifications"), t("ui-result-test-message-unknown"));

/** The new token, which is shown only once; empty if it was not created. */
export async function addMetricsToken(name: string): Promise<string> {
  const made = await done(() => post<AccessTokenSummary>("/api/tokens", { name }), t("ui-the-token-was-not-created"));
  return made?.token ?? "";
}

export const removeMetricsToken = (id: string) =>
  done(() => drop(`/api/tokens/${id}`), t("ui-the-token-may-still-be-valid"));
