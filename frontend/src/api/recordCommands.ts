import { t } from "../state/language";
import { done } from "./commands";
import { drop, post } from "./http";
import type { NewPart, RecordReplay } from "./wire";

/* What these change comes over the live connection. */

const scanAt = (id: string) => `/api/scans/${encodeURIComponent(id)}`;
const unchanged = () => t("ui-the-picture-was-not-changed");

/** The part of the scan that runs, and of the next ones. */
export const nameNextPart = (part: NewPart) => done(() => post("/api/part", part), t("ui-the-part-was-not-named"));

export const namePart = (id: string, part: NewPart) =>
  done(() => post(`${scanAt(id)}/part`, part), t("ui-the-part-was-not-named"));

/** Displays a record alone, or goes back to the last scan. */
export const openRecord = (id: string, on: boolean) => done(() => post(`${scanAt(id)}/opened`, { on }), unchanged());

export const playRecord = (replay: RecordReplay) => done(() => post("/api/view/replay", replay), unchanged());

/** Adds the next scans to a record, or no longer. */
export const continueRecord = (id: string, on: boolean) =>
  done(() => post(`${scanAt(id)}/continued`, { on }), t("ui-the-scan-is-not-continued"));

export const compareRecord = (id: string, reference: string) =>
  done(() => post(`${scanAt(id)}/comparison`, { reference }), t("ui-the-scans-were-not-compared"));

export const endComparison = () => done(() => drop("/api/view/comparison"), unchanged());

export const mergeScans = (ids: string[]) =>
  done(() => post("/api/merged-scans", { ids }), t("ui-the-scans-were-not-merged"));
