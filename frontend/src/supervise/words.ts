import type { Quality } from "../api/types";
import type { CalibrationReport, DeviceReport, StationReport, StationShown } from "../api/watchTypes";
import { age, days, figures } from "../parts/format";
import { measured } from "../parts/lengths";

export interface Fact {
  label: string;
  value: string;
  note: string;
  quality: Quality;
}

/** What a station is doing, and the number that goes with it. */
export function doing({ activity }: StationReport): { title: string; number: string; unit: string; note: string } {
  const { title, step, steps, progress } = activity;
  if (activity.kind === "scanning") {
    const lost = activity.lost_frames ? `, ${figures(activity.lost_frames)} frames lost` : "";
    return {
      title,
      number: figures(activity.rate_points_s),
      unit: "points/s",
      note: `${figures(activity.points)} points${lost}`,
    };
  }
  return { title, number: "", unit: "", note: [steps ? `Step ${step} of ${steps}` : "", progress].filter(Boolean).join(" · ") };
}

export const KINDS: Record<StationReport["activity"]["kind"], string> = {
  idle: "Idle",
  calibrating: "Calibration",
  verifying: "Verification",
  checking_arm: "Arm check",
  scanning: "Scan",
  working: "Job",
};

/** The facts of a station in the order in which they are asked for; devices as old as they are. */
export function facts(report: StationReport, more_s: number): Fact[] {
  return [
    ...report.devices.map((device) => deviceFact(device, more_s)),
    calibrationFact(report.calibration),
    verificationFact(report),
    ...(report.temperature_c === null
      ? []
      : [fact("Temperature", `${figures(report.temperature_c, 1)} °C`, "in the room")]),
    fact("Disk", `${figures(report.disk_free_gb)} GB`, "free", report.disk_free_gb < 1 ? "bad" : report.disk_free_gb < 10 ? "attention" : "neutral"),
    fact("Control", report.control ?? "nobody", report.laser_on ? "laser is on" : "laser is off"),
  ];
}

function fact(label: string, value: string, note: string, quality: Quality = "neutral"): Fact {
  return { label, value, note, quality };
}

function deviceFact(device: DeviceReport, more_s: number): Fact {
  const label = device.name === "arm" ? "Arm" : "Camera";
  if (device.state === "lost" || device.state === "off") {
    return fact(label, device.state, device.age_s === null ? "no data yet" : `for ${age(device.age_s + more_s)}`, "bad");
  }
  if (device.state === "connecting") return fact(label, "connecting", "no data yet", "attention");
  const fresh = device.age_s === null ? "no data" : `${age(device.age_s + more_s)} old`;
  const unit = device.name === "arm" ? "Hz" : "fps";
  const rate = device.rate_hz === null ? fresh : `${figures(device.rate_hz)} ${unit}`;
  return fact(label, rate, rate === fresh ? "" : fresh, "good");
}

function calibrationFact(calibration: CalibrationReport | null): Fact {
  if (!calibration) return fact("Calibration", "none", "nothing can be scanned", "attention");
  const value = measured(calibration.total_um, "µm");
  const old = `${days(calibration.age_days)} old`;
  if (calibration.due) return fact("Calibration", value, `due, ${old}`, "attention");
  const quality = calibration.quality === "neutral" ? "good" : calibration.quality;
  return fact("Calibration", value, `valid, ${old}`, quality);
}

function verificationFact({ verification }: StationReport): Fact {
  if (!verification) return fact("Verified", "not yet", "against a gauge");
  const since = (Date.now() - new Date(verification.at).getTime()) / 86_400_000;
  const words = { good: "passed", attention: "uncertain", bad: "failed", neutral: "done" }[verification.quality];
  return fact("Verified", words, `${days(Math.max(since, 0))} ago`, verification.quality);
}

/** How a station is, in one word and one colour. */
export function stationState(shown: StationShown): { words: string; quality: Quality } {
  const silence = shown.silent_s === null ? "" : ` for ${age(shown.silent_s)}`;
  switch (shown.state) {
    case "lost":
      return { words: `lost${silence}`, quality: "bad" };
    case "off":
      return { words: "switched off", quality: "neutral" };
    case "waiting":
      return { words: "waiting for it", quality: "neutral" };
    case "unknown":
      return { words: "not known, the broker is lost", quality: "attention" };
    case "live":
      return { words: "live", quality: worst(shown.report) };
  }
}

export function worst(report: StationReport | null): Quality {
  const alarms = report?.alarms ?? [];
  if (alarms.some((alarm) => alarm.quality === "bad")) return "bad";
  return alarms.length > 0 ? "attention" : "good";
}
