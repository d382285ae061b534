import { t } from "../state/language";
import { getState, setState } from "../state/store";
import { done } from "./commands";
import { get, post } from "./http";
import type { StationSettings } from "./wire";

type Changeable = Omit<StationSettings, "delay" | "finding_delay" | "findings">;

function send(path: string, body: unknown, whatWas: string): Promise<boolean> {
  return done(async () => {
    const settings = await post<StationSettings>(`/api/settings${path}`, body);
    if (settings) setState({ settings });
  }, whatWas);
}

/** Sets some of the settings; the others stay as they are. */
export async function changeSettings(change: Partial<Changeable>): Promise<boolean> {
  const current = getState().settings;
  if (!current) return false;
  const { delay, finding_delay, findings, ...all } = current;
  return send("", { ...all, ...change }, t("ui-the-settings-were-not-changed"));
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
