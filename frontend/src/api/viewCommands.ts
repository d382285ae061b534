import { t } from "../state/language";
import { clearNotice } from "../state/notices";
import { tell } from "./commands";
import { drop, post } from "./http";
import type { Measure, Region, ShapeName } from "./viewTypes";

/** What it changed comes over the live connection: an answer that comes late is older than that. */
async function change(act: () => Promise<unknown>, whatWas: string): Promise<boolean> {
  try {
    await act();
    clearNotice();
    return true;
  } catch (error) {
    tell(error, whatWas);
    return false;
  }
}

const scanAt = (id: string) => `/api/scans/${encodeURIComponent(id)}`;

/** Within limits in the legend's unit, or automatic ones. */
export const colourBy = (measure: Measure, limits: [number, number] | null = null) =>
  change(
    () => post("/api/view/colours", { measure, low: limits?.[0] ?? null, high: limits?.[1] ?? null }),
    t("the colours were not changed"),
  );

/** `view` is this page's own key of its 3D view. */
export const fitShape = (view: string, shape: ShapeName, region: Region) =>
  change(() => post("/api/view/fits", { view, shape, ...region }), t("nothing was fitted"));

export const removeFit = (id: number) =>
  change(() => drop(`/api/view/fits/${id}`), t("the shape was not removed"));

export const showScan = (id: string, on: boolean) =>
  change(() => post(`${scanAt(id)}/shown`, { on }), t("the picture was not changed"));

export const renameScan = (id: string, name: string) =>
  change(() => post(`${scanAt(id)}/name`, { name }), t("the name was not changed"));

export const deleteScan = (id: string) =>
  change(() => drop(scanAt(id)), t("the scan may not be deleted"));
