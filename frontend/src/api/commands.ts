import { t } from "../state/language";
import { clearNotice, notify } from "../state/notices";
import { getState, putFlow, setState } from "../state/store";
import { NoAnswer, post, postOnce, Refused } from "./http";
import type { Session } from "./accessTypes";
import type { FlowCommand, FlowView } from "./flowTypes";
import type { ScanState } from "./scanTypes";
import type { Problem } from "./types";

/** 128 random bits; works on plain http too, where randomUUID does not exist. */
export function newKey(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

function tellProblem(problem: Problem): void {
  notify({
    quality: problem.status >= 500 ? "bad" : "attention",
    title: problem.detail || problem.title,
    remedy: problem.remedy,
  });
}

function signedOut(session: Session | null): Session | null {
  return session && { ...session, you: null };
}

export function tell(error: unknown, whatWas: string): void {
  if (error instanceof Refused) {
    if (error.problem.code === "signed-out") setState({ session: signedOut(getState().session) });
    return tellProblem(error.problem);
  }
  if (error instanceof NoAnswer) {
    return notify({
      quality: "bad",
      title: t("No answer from the station: {what}", { what: whatWas }),
      detail: t("What the station has already taken is kept there."),
      remedy: t("Check the network; this page reconnects by itself. Then press again."),
      untilHeard: true,
    });
  }
  throw error;
}

/** Does it, and tells what went wrong; whether it was done. */
export async function done(act: () => Promise<unknown>, whatWas: string): Promise<boolean> {
  try {
    await act();
    clearNotice();
    return true;
  } catch (error) {
    tell(error, whatWas);
    return false;
  }
}

export async function sendFlow(name: string, args: Record<string, unknown>): Promise<void> {
  const command: FlowCommand = { name, args, rev: getState().flow?.rev ?? 0, key: newKey() };
  try {
    const view = await postOnce<FlowView>("/api/flow/command", command);
    clearNotice();
    if (view) putFlow(view);
  } catch (error) {
    if (error instanceof Refused && error.problem.status === 409 && error.problem.view) {
      setState({ flow: error.problem.view });
      notify({ quality: "neutral", title: t("The step has moved on; nothing was taken twice.") }, 6000);
      return;
    }
    tell(error, t("the action was not confirmed"));
  }
}

export async function startFlow(): Promise<void> {
  try {
    const view = await post<FlowView>("/api/flow/start");
    clearNotice();
    if (view) putFlow(view);
  } catch (error) {
    tell(error, t("the calibration was not started"));
  }
}

async function scanCommand(path: string, body: unknown, whatWas: string): Promise<void> {
  await done(async () => {
    const scan = await post<ScanState>(path, body);
    if (scan && "state" in scan) setState({ scan });
  }, whatWas);
}

export const startScan = () => scanCommand("/api/scan/start", {}, t("the scan was not started"));
export const stopScan = () => scanCommand("/api/scan/stop", {}, t("the scan may still run"));
export const setScanHand = (on: boolean) =>
  scanCommand("/api/scan/hand", { on }, on ? t("the hand was not started") : t("the hand may still move"));

export async function setLaser(on: boolean): Promise<void> {
  try {
    await post(on ? "/api/laser/on" : "/api/laser/off");
  } catch (error) {
    tell(error, on ? t("the laser was not switched on") : t("the laser may still be on"));
  }
}

export async function stopAll(): Promise<void> {
  try {
    await post("/api/stop");
    notify({ quality: "neutral", title: t("Stopped: laser off, scan and hand at rest.") }, 5000);
  } catch (error) {
    tell(error, t("Stop was not confirmed. Use the switch on the device"));
  }
}

export async function setExposure(exposure_us: number): Promise<void> {
  try {
    await post("/api/exposure", { exposure_us });
  } catch (error) {
    tell(error, t("the exposure was not changed"));
  }
}
