import { clearBanner, notify } from "../state/banner";
import { t } from "../state/language";
import { localized } from "../state/localized";
import { getState, setState } from "../state/store";
import { LeftAlone, withArm } from "./armUse";
import { NoAnswer, post, Refused } from "./http";
import type { Problem, ScanStatus, SensorChoice, SignInState, StudyState } from "./wire";

/** 128 random bits; also on plain http, where randomUUID does not exist. */
export function newKey(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

function notifyOfProblem(problem: Problem): void {
  notify({
    quality: problem.status >= 500 ? "bad" : "attention",
    title: problem.detail || problem.title,
    remedy: problem.remedy,
  });
}

function signedOut(session: SignInState | null): SignInState | null {
  return session && { ...session, you: null };
}

export function notifyOfError(error: unknown, whatWas: string): void {
  if (error instanceof Refused) {
    if (error.problem.code === "signed-out") setState({ session: signedOut(getState().session) });
    notifyOfProblem(error.problem);
  } else if (error instanceof NoAnswer) {
    notify({
      quality: "bad",
      title: t("ui-no-answer-from-the-station", { what: whatWas }),
      detail: t("ui-station-stores-everything-already-recorded"),
      remedy: t("ui-check-network-page-reconnects-automatically-then"),
      untilHeard: true,
    });
  } else if (!(error instanceof LeftAlone)) throw error;
}

/** Acts, and displays an error; returns whether it was done. */
export async function done(act: () => Promise<unknown>, whatWas: string): Promise<boolean> {
  try {
    await withArm(act);
    clearBanner();
    return true;
  } catch (error) {
    notifyOfError(error, whatWas);
    return false;
  }
}

/** Asks, and displays an error; returns the answer, null if there is none. */
export async function ask<T>(act: () => Promise<T | null>, whatWas: string): Promise<T | null> {
  try {
    const answer = await act();
    clearBanner();
    return localized(answer);
  } catch (error) {
    notifyOfError(error, whatWas);
    return null;
  }
}

async function scanCommand(path: string, body: unknown, whatWas: string): Promise<void> {
  await done(async () => {
    const scan = await post<ScanStatus>(path, body);
    if (scan && "state" in scan) setState({ scan });
  }, whatWas);
}

export const startScan = () => scanCommand("/api/scan/start", {}, t("ui-the-scan-was-not-started"));
export const stopScan = () => scanCommand("/api/scan/stop", {}, t("ui-the-scan-may-still-run"));
export const setSimulatedOperator = (on: boolean) =>
  scanCommand(
    "/api/scan/simulation",
    { on },
    on ? t("ui-the-simulated-operator-was-not-started") : t("ui-simulated-operator-may-still-moving"),
  );

export async function setLaser(on: boolean): Promise<void> {
  try {
    await post(on ? "/api/laser/on" : "/api/laser/off");
  } catch (error) {
    notifyOfError(error, on ? t("ui-the-laser-was-not-switched-on") : t("ui-the-laser-may-still-be-on"));
  }
}

export async function stopAll(): Promise<void> {
  try {
    await post("/api/stop");
    notify({ quality: "neutral", title: t("ui-stopped-laser-off-nothing-running") }, 5000);
  } catch (error) {
    notifyOfError(error, t("ui-stop-not-confirmed-use-switch-device"));
  }
}

export async function selectSensor(name: string): Promise<void> {
  await done(async () => {
    const sensors = await post<SensorChoice>("/api/sensor", { name });
    if (sensors) setState({ sensors });
  }, t("ui-the-sensor-was-not-selected"));
}

export async function setExposure(exposure_us: number): Promise<void> {
  try {
    await post("/api/exposure", { exposure_us });
  } catch (error) {
    notifyOfError(error, t("ui-the-exposure-was-not-changed"));
  }
}

export async function makeStudy(id: string): Promise<StudyState | null> {
  try {
    return localized(await post<StudyState>(`/api/verifications/${id}/study`, {}));
  } catch (error) {
    notifyOfError(error, t("ui-the-clouds-were-not-rebuilt"));
    return null;
  }
}
