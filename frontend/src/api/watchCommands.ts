import { clearBanner } from "../state/banner";
import { t } from "../state/language";
import { localized } from "../state/localized";
import { notifyOfError } from "./commands";
import { drop, get, post } from "./http";
import type { ApiTokenSummary, BackupState, Notifications } from "./wire";

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
  /** Null leaves it, empty takes it away. */
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

export const addMetricsToken = (name: string) =>
  done(() => post<ApiTokenSummary>("/api/tokens", { name }), t("ui-the-token-was-not-created"));

export const removeMetricsToken = (id: string) =>
  done(() => drop(`/api/tokens/${id}`), t("ui-the-token-may-still-be-valid"));
