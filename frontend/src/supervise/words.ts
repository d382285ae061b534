import type { Quality } from "../api/types";
import type { CalibrationReport, DeviceReport, StationReport, StationShown } from "../api/watchTypes";
import { age, days, daysAgo, figures } from "../parts/format";
import { measured } from "../parts/lengths";
import { counted, t, words } from "../state/language";

export interface Fact {
  id: string;
  label: string;
  value: string;
  note: string;
  quality: Quality;
}

/** What a station is doing, and the number that goes with it. */
export function doing({ activity }: StationReport): { title: string; number: string; unit: string; note: string } {
  const { title, step, steps, progress } = activity;
  if (activity.kind === "scanning") {
    const points = counted(activity.points, "{n} point", "{n} points");
    const lost = activity.lost_frames ? `, ${counted(activity.lost_frames, "{n} frame lost", "{n} frames lost")}` : "";
    return {
      title,
      number: figures(activity.rate_points_s),
      unit: t("points/s"),
      note: points + lost,
    };
  }
  return { title, number: "", unit: "", note: [steps ? t("Step {n} of {all}", { n: step, all: steps }) : "", progress].filter(Boolean).join(" · ") };
}

export const KINDS: Record<StationReport["activity"]["kind"], string> = {
  idle: words("Idle"),
  calibrating: words("Calibration"),
  verifying: words("Verification"),
  checking_arm: words("Arm check"),
  scanning: words("Scan"),
  working: words("Job"),
};

/** The facts of a station in the order in which they are asked for; devices as old as they are. */
export function facts(report: StationReport, more_s: number): Fact[] {
  return [
    ...report.devices.map((device) => deviceFact(device, more_s)),
    calibrationFact(report.calibration),
    verificationFact(report),
    ...(report.temperature_c === null
      ? []
      : [fact("temperature", t("Temperature"), `${figures(report.temperature_c, 1)} °C`, t("in the room"))]),
    fact("disk", t("Disk"), `${figures(report.disk_free_gb)} GB`, t("free"), report.disk_free_gb < 1 ? "bad" : report.disk_free_gb < 10 ? "attention" : "neutral"),
    fact("control", t("Control"), report.control ?? t("nobody"), report.laser_on ? t("laser is on") : t("laser is off")),
  ];
}

function fact(id: string, label: string, value: string, note: string, quality: Quality = "neutral"): Fact {
  return { id, label, value, note, quality };
}

function deviceFact(device: DeviceReport, more_s: number): Fact {
  const arm = device.name === "arm";
  const told = (value: string, note: string, quality: Quality) => fact(device.name, arm ? t("Arm") : t("Camera"), value, note, quality);
  const old = device.age_s === null ? null : age(device.age_s + more_s);
  if (device.state === "lost" || device.state === "off") {
    const value = device.state === "lost" ? t("lost") : t("off");
    return told(value, old === null ? t("no data yet") : t("for {age}", { age: old }), "bad");
  }
  if (device.state === "connecting") return told(t("connecting"), t("no data yet"), "attention");
  const fresh = old === null ? t("no data") : t("{age} old", { age: old });
  if (device.rate_hz === null) return told(fresh, "", "good");
  const rate = { n: figures(device.rate_hz) };
  return told(arm ? t("{n} Hz", rate) : t("{n} fps", rate), fresh, "good");
}

function calibrationFact(calibration: CalibrationReport | null): Fact {
  const told = (value: string, note: string, quality: Quality) => fact("calibration", t("Calibration"), value, note, quality);
  if (!calibration) return told(t("none"), t("nothing can be scanned"), "attention");
  const value = measured(calibration.total_um, "µm");
  const values = { age: days(calibration.age_days) };
  if (calibration.due) return told(value, t("due, {age} old", values), "attention");
  const quality = calibration.quality === "neutral" ? "good" : calibration.quality;
  return told(value, t("valid, {age} old", values), quality);
}

function verificationFact({ verification }: StationReport): Fact {
  if (!verification) return fact("verified", t("Verified"), t("not yet"), t("against a gauge"));
  const since = (Date.now() - new Date(verification.at).getTime()) / 86_400_000;
  const result = { good: t("passed"), attention: t("uncertain"), bad: t("failed"), neutral: t("done") }[verification.quality];
  return fact("verified", t("Verified"), result, daysAgo(Math.max(since, 0)), verification.quality);
}

/** How a station is, in one word and one colour. */
export function stationState(shown: StationShown, more_s = 0): { words: string; quality: Quality } {
  switch (shown.state) {
    case "lost":
      return { words: shown.silent_s === null ? t("lost") : t("lost for {age}", { age: age(shown.silent_s + more_s) }), quality: "bad" };
    case "off":
      return { words: t("switched off"), quality: "neutral" };
    case "waiting":
      return { words: t("waiting for it"), quality: "neutral" };
    case "unknown":
      return { words: t("not known, the broker is lost"), quality: "attention" };
    case "live":
      return { words: t("live"), quality: worst(shown.report) };
  }
}

export function worst(report: StationReport | null): Quality {
  const alarms = report?.alarms ?? [];
  if (alarms.some((alarm) => alarm.quality === "bad")) return "bad";
  return alarms.length > 0 ? "attention" : "good";
}
