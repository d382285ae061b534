import { t } from "../state/language";
import { setState } from "../state/store";
import { done } from "./commands";
import { get, post } from "./http";
import type { SettingsChange, StationSettings } from "./wire";

function send(path: string, body: unknown, whatWas: string): Promise<boolean> {
  return done(async () => {
    const settings = await post<StationSettings>(`/api/settings${path}`, body);
    if (settings) setState({ settings });
  }, whatWas);
}

/** Sets some of the settings; the others stay as they are. */
export function changeSettings(change: SettingsChange): Promise<boolean> {
  return send("", change, t("ui-the-settings-were-not-changed"));
}

/** The findings depend on the connected devices: loaded again when the page opens. */
export async function readSettings(): Promise<void> {
  try {
    setState({ settings: await get<StationSettings>("/api/settings") });
  } catch {
    /* the live connection brings them, too */
  }
}

export const exposeByTheLine = async () => {
  await send("/exposure", {}, t("ui-the-exposure-was-not-changed"));
};
export const findDelay = async () => {
  await send("/delay/find", {}, t("ui-the-delay-was-not-determined"));
};
export const passForDelay = async () => {
  await send("/delay/pass", {}, t("ui-the-pass-was-not-started"));
};
export const applyDelay = async (on: boolean) => {
  await send("/delay", { on }, t("ui-the-delay-was-not-changed"));
};
