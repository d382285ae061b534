/** What is valid, what is due, what comes next. The Python side of each shape is in app/wire/schema.py and app/guide/common/validity.py. */

import type { Finding, Quality } from "./types";

export interface CalibrationSummary {
  id: string;
  name: string;
  accepted_at: string;
  age_days: number;
  total_um: number;
  verdict: Quality;
  active: boolean;
  arm_serial: string;
  sensor_serial: string;
  object_serial: string;
}

export interface Station {
  name: string;
  version: string;
  /** True on a simulated station, which has a simulated operator. */
  has_hand: boolean;
  /** True where the devices are simulated. */
  simulated: boolean;
}

/** Home: what is valid, what is due, what to do next. */
export interface Home {
  station: Station;
  calibration: CalibrationSummary | null;
  checks: Validity[];
  /** Ambient, where it was entered or measured recently. */
  temperature_c: number | null;
  findings: Finding[];
  next: Next;
}

export type WorkPage = "home" | "calibrate" | "verify" | "scan" | "arm" | "records";

/** One thing that must be in order to measure, in one line. */
export interface Validity {
  id: "calibration" | "verification" | "tip" | "arm";
  title: string;
  state: "valid" | "due" | "missing" | "failed" | "unsure";
  quality: Quality;
  /** What it is worth, or why it is due, in one sentence. */
  text: string;
  at: string | null;
  page: WorkPage;
  action: string;
}

/** What to do next. */
export interface Next {
  label: string;
  page: WorkPage;
  text: string;
}
