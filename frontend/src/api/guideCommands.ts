import { clearBanner, notify } from "../state/banner";
import { t } from "../state/language";
import { type Guide, getState, putView, type SessionView } from "../state/store";
import { withArm } from "./armUse";
import { done, newKey, notifyOfError } from "./commands";
import { post, postOnce, Refused } from "./http";
import type { ArmView, FlowCommand, PerformanceView } from "./wire";

/** By its guide, the value that was set last: whether it was taken. */
const settings = new Map<Guide, Promise<boolean>>();

/**
 * Sets a value that was typed or chosen, after the one before it. What is pressed in the meantime
 * follows, unless the value is refused.
 */
export async function setValue(guide: Guide, name: string, args: Record<string, unknown>): Promise<void> {
  const before = settings.get(guide) ?? Promise.resolve(true);
  const taken = before.then(() => send(guide, name, args));
  settings.set(guide, taken);
  await taken;
  if (settings.get(guide) === taken) settings.delete(guide);
}

export async function sendCommand(guide: Guide, name: string, args: Record<string, unknown> = {}): Promise<void> {
  if ((await settings.get(guide)) !== false) await send(guide, name, args);
}

/** Whether it was done. */
async function send(guide: Guide, name: string, args: Record<string, unknown>): Promise<boolean> {
  const command: FlowCommand = { name, args, rev: getState()[guide]?.rev ?? 0, key: newKey() };
  try {
    const view = await withArm(() => postOnce<SessionView>(`/api/${guide}/command`, command));
    clearBanner();
    if (view) putView(guide, view);
    return true;
  } catch (error) {
    if (error instanceof Refused && error.problem.status === 409 && error.problem.view) {
      putView(guide, error.problem.view);
      notify({ quality: "neutral", title: t("ui-step-already-advanced-nothing-recorded-twice") }, 6000);
      return false;
    }
    notifyOfError(error, t("ui-the-action-was-not-confirmed"));
    return false;
  }
}

async function start(guide: Guide, body: unknown, whatWas: string): Promise<void> {
  await done(async () => {
    const view = await post<SessionView>(`/api/${guide}/start`, body);
    if (view) putView(guide, view);
  }, whatWas);
}

export const startCalibration = () => start("flow", {}, t("ui-the-calibration-was-not-started"));
export const startVerification = () => start("verify", {}, t("ui-the-verification-was-not-started"));
export const startPerformance = (test: PerformanceView["test"]) =>
  start("performance", { test }, t("ui-the-test-was-not-started"));
export const startInspection = () => start("parts", {}, t("ui-part-was-not-started"));
export const startArm = (purpose: ArmView["purpose"]) => start("arm", { purpose }, t("ui-the-session-was-not-started"));
