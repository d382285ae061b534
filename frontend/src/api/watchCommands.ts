import { t } from "../state/language";
import { clearNotice } from "../state/notices";
import { spoken } from "../state/spoken";
import { tell } from "./commands";
import { drop, get, post } from "./http";
import type { BackupState, Notifications, Scraper } from "./watchTypes";

async function done<T>(act: () => Promise<T | null>, whatWas: string): Promise<T | null> {
  try {
    const answer = await act();
    clearNotice();
    return spoken(answer);
  } catch (error) {
    tell(error, whatWas);
    return null;
  }
}

export const startBackup = () => done(() => post<BackupState>("/api/backup"), t("no backup was begun"));

export interface NotificationsChange {
  url: string;
  /** Null leaves it, empty takes it away. */
  secret: string | null;
  done: boolean;
  fault: boolean;
  due: boolean;
}

export const changeNotifications = (change: NotificationsChange) =>
  done(() => post<Notifications>("/api/notifications", change), t("the notifications were not changed"));

export const tryNotifications = () =>
  done(() => post<Notifications>("/api/notifications/test"), t("nothing was sent"));

export const readNotifications = () =>
  done(() => get<Notifications>("/api/notifications"), t("what became of the message is not known here"));

export const addScraper = (name: string) =>
  done(() => post<Scraper>("/api/scrapers", { name }), t("no token was made"));

export const removeScraper = (id: string) =>
  done(() => drop(`/api/scrapers/${id}`), t("the token may still be good"));
