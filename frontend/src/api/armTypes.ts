/** The arm's own flows. The Python side of each shape is in app/guide/arm/view.py. */

import type { Action, ChoiceOption, Finding, LiveNumber, Quality, Step, Vec3 } from "./types";
import type { TouchLine } from "./verifyTypes";

/** How far one joint has turned in this seat, and may turn. */
export interface JointSwing {
  name: string;
  lowest_deg: number | null;
  highest_deg: number | null;
  now_deg: number | null;
  limit_low_deg: number;
  limit_high_deg: number;
}

/** What the tip is put to: a seat, an end of a ball bar, or a sphere touched from outside. */
export interface Artefact {
  kind: "seat" | "bar" | "sphere";
  /** The bar's length or the sphere's diameter, by its certificate. */
  size_mm: number | null;
  standard_uncertainty_mm: number;
}

/** One seat, end of a bar, or sphere of the session. */
export interface SeatLine {
  name: string;
  points: number;
  /** The largest of the three axes; of a sphere the largest distance from it. */
  half_range_um: number;
  /** Of a bar what its length seems to be. */
  note: string;
}

/** One line of before and after. */
export interface Before {
  title: string;
  before_um: number;
  after_um: number;
}

/** One of the arm's parameters that was moved. */
export interface ParameterLine {
  name: string;
  unit: string;
  before: number;
  after: number;
  standard_uncertainty: number;
}

/** Unchanged parameters, and why. */
export interface KeptLine {
  names: string;
  why: string;
}

/** Two parameters that the places hardly separate. */
export interface CorrelatedLine {
  first: string;
  second: string;
  coefficient: number;
}

/** What an identification found. */
export interface ArmResult {
  volume_before_um: number;
  volume_after_um: number;
  /** Whether a calibrated length determined the arm's scale. */
  size_known: boolean;
  places: number;
  lines: Before[];
  parameters: ParameterLine[];
  kept: KeptLine[];
  correlated: CorrelatedLine[];
}

/** The points of the present seat about their middle, and how the arm swung. */
export interface ArmPicture {
  tips_um: Vec3[];
  half_range_um: Vec3 | null;
  two_sigma_um: Vec3 | null;
  encoders_two_sigma_um: Vec3 | null;
  limit_um: number | null;
  joints: JointSwing[];
  seats: SeatLine[];
  result: ArmResult | null;
  /** Of the touched sphere, from above. */
  touches: TouchLine[];
  /** Its radius. */
  sphere_mm: number | null;
  tip: TipResult | null;
}

/** What a check of the tip found. */
export interface TipResult {
  diameter_mm: number;
  expected_mm: number;
  error_um: number;
  expanded_uncertainty_um: number;
  scatter_um: number;
  bend_um: number | null;
  limit_um: number | null;
  decision: "pass" | "fail" | "uncertain" | "none";
}

/** The whole state of the arm session, owned by the server. */
export interface ArmView {
  session_id: string;
  rev: number;
  running: boolean;
  purpose: "check" | "tip" | "identify";
  arms: ChoiceOption[];
  arm: string;
  /** What the tip is put to next, in an identification. */
  artefact: Artefact;
  steps: Step[];
  step: string;
  title: string;
  instruction: string;
  picture: ArmPicture;
  number: LiveNumber | null;
  progress: { done: number; of: number; text: string } | null;
  findings: Finding[];
  actions: Action[];
  busy: { text: string; fraction: number | null } | null;
}

/** One check of the history. */
export interface ArmCheckSummary {
  id: string;
  at: string;
  arm_name: string;
  arm_serial: string;
  points: number;
  half_range_um: Vec3;
  two_sigma_um: Vec3;
  limit_um: number | null;
  verdict: Quality;
}

/** One check of the tip. */
export interface TipCheckSummary {
  id: string;
  at: string;
  arm_name: string;
  arm_serial: string;
  touches: number;
  diameter_mm: number;
  expected_mm: number;
  error_um: number;
  expanded_uncertainty_um: number;
  scatter_um: number;
  bend_um: number | null;
  limit_um: number | null;
  decision: "pass" | "fail" | "uncertain" | "none";
  /** What was found, in one sentence. */
  text: string;
  verdict: Quality;
}

/** One identification of the arm. */
export interface IdentificationSummary {
  id: string;
  at: string;
  arm_name: string;
  arm_serial: string;
  volume_before_um: number;
  volume_after_um: number;
  size_known: boolean;
}
