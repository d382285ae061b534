/** Verifications. The Python side of each shape is in app/guide/verify/view.py and app/wire/schema.py. */

import type { Action, Finding, LiveNumber, Step } from "./types";
import type { StudyFile } from "./verifyFiles";

/** One of the data folder's gauges. */
export interface GaugeOption {
  id: string;
  shape: "plane" | "sphere";
  label: string;
  detail: string;
}

/** One contact point, from above the gauge; without a place until the gauge is fixed. */
export interface TouchLine {
  index: number;
  x_mm: number | null;
  y_mm: number | null;
  residual_um: number | null;
}

/** One cloud; the errors are against the probe, and the radius against the certificate. */
export interface CloudLine {
  number: number;
  state: "scanning" | "measuring" | "good" | "refused" | "aside";
  /** Why it is of no use, or what should be known of it. */
  text: string;
  points: number;
  used: number;
  rms_um: number | null;
  form_um: number | null;
  angle_arcsec: number | null;
  z_error_um: number | null;
  offset_error_um: number | null;
  radius_error_um: number | null;
  centre_error_um: number | null;
  map_url: string;
}

/** One figure against its limit. */
export interface FigureLine {
  name: string;
  title: string;
  unit: string;
  value: number;
  expanded_uncertainty: number;
  limit: number | null;
  decision: "pass" | "fail" | "uncertain" | "none";
  reason: string;
  clouds: number[];
}

export interface VerdictLine {
  result: "pass" | "fail" | "uncertain";
  text: string;
}

/** All that is drawn of a verification. */
export interface VerifyPicture {
  shape: "plane" | "sphere" | null;
  radius_mm: number | null;
  touches: TouchLine[];
  touch_rms_um: number | null;
  scanning: boolean;
  clouds: CloudLine[];
  figures: FigureLine[];
  verdict: VerdictLine | null;
}

/** The whole state of the verification, owned by the server. */
export interface VerifyView {
  session_id: string;
  rev: number;
  running: boolean;
  calibration_id: string;
  calibration: string;
  gauges: GaugeOption[];
  gauge: string;
  steps: Step[];
  step: string;
  title: string;
  instruction: string;
  picture: VerifyPicture;
  number: LiveNumber | null;
  progress: { done: number; of: number; text: string } | null;
  findings: Finding[];
  actions: Action[];
  busy: { text: string; fraction: number | null } | null;
}

export interface VerificationSummary {
  id: string;
  accepted_at: string;
  calibration_id: string;
  calibration: string;
  result: "pass" | "fail" | "uncertain";
  text: string;
  shape: "plane" | "sphere";
  gauge: string;
  clouds: number;
  touched: boolean;
  operator: string;
}

/** Of the clouds rebuilt with every calibration: under way, or done, or neither. */
export interface StudyState {
  running: boolean;
  text: string;
  fraction: number | null;
  accepted: number;
  study: StudyFile | null;
}
