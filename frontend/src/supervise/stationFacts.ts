import type { Quality } from "../api/types";
import type { CalibrationReport, DeviceReport, RemoteStation, StationReport } from "../api/wire";
import { age, days, daysAgo, figures } from "../controls/format";
import { measured } from "../controls/lengths";
import { POINT_DECIMALS } from "../controls/uncertainty";
import type { PlainId } from "../messages/text";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { stampsText } from "../state/stamps";

export interface Fact {
  id: string;
  label: string;
  value: string;
  note: string;
  quality: Quality;
}

/** The activity of a station, and its number. */
export function doing({ activity }: StationReport): { title: string; number: string; unit: string; note: string } {
  const { title, step, steps, progress } = activity;
  if (activity.kind === "scanning") {
    const points = t("ui-n-points", { n: activity.points });
    const lost = activity.lost_frames ? `, ${t("ui-frames-lost", { n: activity.lost_frames })}` : "";
    return {
      title,
      number: figures(activity.rate_points_s),
      unit: t("ui-points-s"),
      note: points + lost,
    };
  }
  return {
    title,
    number: "",
    unit: "",
    note: [steps ? t("ui-step-of", { n: step, all: steps }) : "", progress].filter(Boolean).join(" · "),
  };
}

export const KINDS: Record<StationReport["activity"]["kind"], PlainId> = {
  idle: "ui-idle",
  calibrating: "ui-calibration",
  verifying: "ui-verification",
  checking_arm: "ui-arm-check",
  scanning: "ui-scan",
  working: "ui-job",
};

/** The sensors of a station with several, each with its name; none of the others. */
export function sensorFacts(report: StationReport): Fact[] {
  const sensors = deviceFacts(report, 0).filter((_, i) => report.devices[i]?.name === "camera");
  return sensors.length > 1 ? sensors : [];
}

function deviceFacts({ devices }: StationReport, more_s: number): Fact[] {
  // names may be equal, or missing from a station of an earlier version
  return devices.map((device, i) => ({ ...deviceFact(device, more_s), id: `${device.name}-${i}` }));
}

/** The facts of a station in order of importance, with the age of the device data. */
export function facts(report: StationReport, more_s: number): Fact[] {
  return [
    ...deviceFacts(report, more_s),
    calibrationFact(report.calibration),
    verificationFact(report),
    ...(report.temperature_c === null
      ? []
      : [fact("temperature", t("ui-temperature"), measured(report.temperature_c, "°C", 1), t("ui-ambient"))]),
    fact(
      "disk",
      t("ui-disk"),
      measured(report.disk_free_gb, "GB"),
      t("ui-free"),
      report.disk_free_gb < 1 ? "bad" : report.disk_free_gb < 10 ? "attention" : "neutral",
    ),
    fact("control", t("ui-control"), report.control ?? t("ui-nobody"), laserWords(report)),
  ];
}

/** A station of an earlier version says only whether its laser was switched on. */
function laserWords({ laser, laser_on }: StationReport): string {
  if (laser_on) return t("ui-laser-is-on-lowercase");
  return laser === "off" ? t("ui-laser-is-off-lowercase") : t("ui-laser-is-unknown-lowercase");
}

function fact(id: string, label: string, value: string, note: string, quality: Quality = "neutral"): Fact {
  return { id, label, value, note, quality };
}

/** A device with the sign that its station gives it; one of an earlier version gives none to what it receives. */
function deviceFact(device: DeviceReport, more_s: number): Fact {
  const arm = device.name === "arm";
  const sensor = device.sensor ?? "";
  const stated = (value: string, note: string, otherwise: Quality) =>
    fact(device.name, arm ? t("ui-arm") : isolated(sensor) || t("ui-camera"), value, note, device.quality ?? otherwise);
  const old = device.age_s === null ? null : age(device.age_s + more_s);
  if (device.state === "lost" || device.state === "off") {
    const value = device.state === "lost" ? t("ui-lost") : t("ui-off");
    return stated(value, old === null ? t("ui-no-data-yet-lowercase") : t("ui-for", { age: old }), "bad");
  }
  // or not chosen at all, which its text says
  if (device.state === "connecting") return stated(t("ui-no-data"), device.text, "attention");
  const fresh = old === null ? t("ui-no-data") : t("ui-old-age", { age: old });
  if (device.rate_hz === null) return stated(fresh, "", "neutral");
  const rate = { n: figures(device.rate_hz) };
  // a station of an earlier version does not say where they come from
  const stamps = device.stamps ? [t("ui-stamps-by", { stamps: stampsText(device.stamps) })] : [];
  const notes = [fresh, lossText(device), ...stamps];
  return stated(arm ? t("ui-hz", rate) : t("ui-fps", rate), notes.join(" · "), "neutral");
}

/** The losses that the sign is given by; of a station of an earlier version, those since its start. */
function lossText({ lost_lately, received_lately, lost, corrupt }: DeviceReport): string {
  if (lost_lately == null) return t("ui-lost-and-corrupt", { lost, corrupt });
  return t("ui-lost-lately", { n: figures(lost_lately), all: figures(lost_lately + (received_lately ?? 0)) });
}

function calibrationFact(calibration: CalibrationReport | null): Fact {
  const stated = (value: string, note: string, quality: Quality) =>
    fact("calibration", t("ui-calibration"), value, note, quality);
  if (!calibration) return stated(t("ui-none"), t("ui-scanning-is-not-possible"), "attention");
  const value = measured(calibration.total_um, "µm", POINT_DECIMALS);
  const values = { age: days(calibration.age_days) };
  if (calibration.due) return stated(value, t("ui-due-old", values), "attention");
  const quality = calibration.quality === "neutral" ? "good" : calibration.quality;
  return stated(value, t("ui-valid-old", values), quality);
}

function verificationFact({ verification }: StationReport): Fact {
  if (!verification) return fact("verified", t("ui-verified"), t("ui-not-yet"), t("ui-against-a-gauge"));
  const since = (Date.now() - new Date(verification.at).getTime()) / 86_400_000;
  const result = {
    good: t("ui-passed-lowercase"),
    attention: t("ui-undecided"),
    bad: t("ui-failed-lowercase"),
    neutral: t("ui-done"),
  }[verification.quality];
  return fact("verified", t("ui-verified"), result, daysAgo(Math.max(since, 0)), verification.quality);
}

/** The state of a station in one word and one colour. */
export function stationState(station: RemoteStation, more_s = 0): { words: string; quality: Quality } {
  switch (station.state) {
    case "lost":
      return {
        words: station.silent_s === null ? t("ui-lost") : t("ui-lost-for", { age: age(station.silent_s + more_s) }),
        quality: "bad",
      };
    case "off":
      return { words: t("ui-switched-off"), quality: "neutral" };
    case "waiting":
      return { words: t("ui-waiting"), quality: "neutral" };
    case "unknown":
      return { words: t("ui-unknown-the-broker-is-offline"), quality: "attention" };
    case "live":
      return { words: t("ui-live"), quality: worst(station.report) };
  }
}

export function worst(report: StationReport | null): Quality {
  const alarms = report?.alarms ?? [];
  if (alarms.some((alarm) => alarm.quality === "bad")) return "bad";
  return alarms.length > 0 ? "attention" : "good";
}
