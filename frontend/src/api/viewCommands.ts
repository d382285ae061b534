import { t } from "../state/language";
import { done } from "./commands";
import { drop, post } from "./http";
import type { AskedShape, Measure, Region, ShapeName, Viewpoint } from "./types";

/* What these change comes over the live connection: an answer that comes late is older than that. */

const scanAt = (id: string) => `/api/scans/${encodeURIComponent(id)}`;

/** With limits in the unit of the legend, or automatic ones. */
export const colourBy = (measure: Measure, limits: [number, number] | null = null) =>
  done(
    () => post("/api/view/colours", { measure, low: limits?.[0] ?? null, high: limits?.[1] ?? null }),
    t("ui-the-colours-were-not-changed"),
  );

/** `view` is this page's own key of its 3D view. */
export const turnView = (view: string, viewpoint: Viewpoint) =>
  done(() => post("/api/view/viewpoint", { view, viewpoint }), t("ui-the-viewpoint-was-not-changed"));

/** `view` is this page's own key of its 3D view. */
export const fitShape = (view: string, shape: AskedShape, region: Region) =>
  done(() => post("/api/view/fits", { view, shape, ...region }), t("ui-nothing-was-fitted"));

/** Cuts away what the page with this key shows in a rectangle, or what lies outside of it. */
export const cutPoints = (view: string, region: Region, outside: boolean) =>
  done(() => post("/api/view/cuts", { view, outside, ...region }), t("ui-nothing-was-cut"));

export const undoCut = () => done(() => drop("/api/view/cuts/last"), t("ui-the-cut-was-not-undone"));

export const showArm = (on: boolean) => done(() => post("/api/view/arm", { on }), t("ui-the-picture-was-not-changed"));

export const markWeak = (on: boolean) =>
  done(() => post("/api/view/weak", { on }), t("ui-the-picture-was-not-changed"));

/** Fits another shape to the points of one. */
export const changeShape = (id: number, shape: ShapeName) =>
  done(() => post(`/api/view/fits/${id}/shape`, { shape }), t("ui-nothing-was-fitted"));

/** Measures between two shapes. */
export const relateShapes = (first: number, second: number) =>
  done(() => post("/api/view/relations", { first, second }), t("ui-nothing-was-measured-between"));

/** Takes back the last change of shapes and of dimensions between them. */
export const undoShapes = () => done(() => drop("/api/view/fits/last-change"), t("ui-the-change-was-not-undone"));

/** A shape with its dimensions, or a dimension. */
export const removeFit = (id: number) => done(() => drop(`/api/view/fits/${id}`), t("ui-the-shape-was-not-removed"));

export const showScan = (id: string, on: boolean) =>
  done(() => post(`${scanAt(id)}/shown`, { on }), t("ui-the-picture-was-not-changed"));

export const renameScan = (id: string, name: string) =>
  done(() => post(`${scanAt(id)}/name`, { name }), t("ui-the-name-was-not-changed"));

export const fetchScan = (id: string) => done(() => post(`${scanAt(id)}/fetch`), t("ui-the-scan-was-not-fetched"));

export const deleteScan = (id: string) => done(() => drop(scanAt(id)), t("ui-the-scan-may-still-exist"));
