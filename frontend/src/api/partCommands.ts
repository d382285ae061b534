import { t } from "../state/language";
import { ask, done } from "./commands";
import { drop, NoAnswer, post, putBytes } from "./http";
import type { ArrivedBytes, MapWish, NewComparison, PictureSpot, PlaceOnMap } from "./wire";

export type MapMode = NonNullable<MapWish["mode"]>;

/** The station takes no more at once. */
const PIECE_BYTES = 200_000;

const scanAt = (id: string) => `/api/scans/${encodeURIComponent(id)}`;

/** Sends the file of a part piece by piece; its reading is in the live state. */
export const sendPart = (file: File) =>
  done(async () => {
    const begun = await post<ArrivedBytes>("/api/cad", { name: file.name.slice(-255), size: file.size });
    for (let at = 0; begun && at < file.size; at += PIECE_BYTES) {
      const path = `/api/cad/${begun.id}/file?at=${at}`;
      await putTwice(path, file.slice(at, at + PIECE_BYTES));
    }
  }, t("ui-the-part-was-not-taken"));

/** A piece that the station has already is not taken twice. */
async function putTwice(path: string, piece: Blob): Promise<void> {
  try {
    await putBytes(path, piece);
  } catch (error) {
    if (!(error instanceof NoAnswer)) throw error;
    await putBytes(path, piece);
  }
}

export const removePart = (id: string) => done(() => drop(`/api/cad/${id}`), t("ui-the-part-was-not-removed"));

export const comparePart = (scan: string, wish: NewComparison) =>
  done(() => post(`${scanAt(scan)}/deviation`, wish), t("ui-the-scan-was-not-compared"));

export const cancelComparison = () => done(() => post("/api/comparison/cancel"), t("ui-the-comparison-may-still-run"));

export const showMap = (scan: string, mode: MapMode) =>
  done(() => post(`${scanAt(scan)}/deviation/shown`, { on: true, mode }), t("ui-the-picture-was-not-changed"));

export const hideMap = (scan: string) =>
  done(() => post(`${scanAt(scan)}/deviation/shown`, { on: false }), t("ui-the-picture-was-not-changed"));

export const removeMap = (scan: string) =>
  done(() => drop(`${scanAt(scan)}/deviation`), t("ui-the-map-was-not-removed"));

/** What the map has at a place of this page's picture. */
export const askPlace = (scan: string, spot: PictureSpot) =>
  ask(() => post<PlaceOnMap>(`${scanAt(scan)}/deviation/place`, spot), t("ui-the-place-is-not-known"));
