/** What the server sends and takes. The Python side of each shape is in app/api/schema.py. */

import type { Control, You } from "./accessTypes";
import type { ArmView } from "./armTypes";
import type { VerifyView } from "./verifyTypes";
import type { ViewState } from "./viewTypes";

export type Quality = "good" | "attention" | "bad" | "neutral";

/** A number that the operator watches: value and unit, never one without the other. */
export interface LiveNumber {
  label: string;
  value: number | null;
  unit: string;
  decimals: number;
  quality: Quality;
  /** e.g. "limit 50 µm" */
  note: string;
}

export interface Finding {
  quality: Quality;
  /** One sentence, with the number and the limit. */
  text: string;
  /** What to do; may be empty. */
  remedy: string;
  /** The pose that it is about, where it is about one. */
  pose: number | null;
}

/** One thing the operator may do now. The client posts `name` and `args` as they are. */
export interface Action {
  name: string;
  label: string;
  args: Record<string, unknown>;
  primary: boolean;
  enabled: boolean;
  /** Why it is not possible now; shown beside the disabled button. */
  why_not: string;
  /** A question to put before a destructive act; empty: no question. */
  confirm: string;
}

export interface Step {
  id: string;
  title: string;
  state: "done" | "current" | "todo" | "stale";
}

export type Vec3 = [number, number, number];

/** The block's geometry for drawing, in mm, from its certificate. */
export interface BlockGeometry {
  edges_x_mm: number[];
  front_y_mm: number;
  back_y_mm: number;
  crest_z_mm: number;
  floor_z_mm: number;
  base_z_mm: number;
}

/** A touched point on the object. */
export interface TouchedPoint {
  index: number;
  face: string;
  /** Where it lies on the object (object frame, mm), null until an alignment exists. */
  at_mm: Vec3 | null;
  residual_um: number | null;
  outlier: boolean;
}

export interface FaceProgress {
  face: string;
  title: string;
  taken: number;
  wanted: number;
  selected: boolean;
  rms_um: number | null;
  /** Suggested places to touch, object frame, mm. */
  suggested_mm: Vec3[];
}

export interface ChoiceOption {
  id: string;
  label: string;
  detail: string;
}

export interface Choice {
  /** arm, object, sensor */
  field: string;
  title: string;
  options: ChoiceOption[];
  selected: string;
}

export interface DeviceLine {
  title: string;
  quality: Quality;
  text: string;
}

export interface ImageCorner {
  name: string;
  u: number;
  v: number;
  residual_px: number | null;
  /** Of a result: found minus computed. */
  off_px: [number, number] | null;
}

/** Why a picture was declined, as a line in it. */
export interface ImageMark {
  kind: "clipped" | "segment" | "outline" | "disagrees" | "outside";
  u0: number;
  v0: number;
  u1: number;
  v1: number;
}

export interface BudgetRow {
  source: string;
  /** Standard uncertainty of a reconstructed point in the flange frame, k = 1. */
  value_um: number;
}

export interface FaceResult {
  face: string;
  points: number;
  rms_um: number;
  form_um: number;
}

export interface WorstPoint {
  kind: "contact" | "corner" | "stripe";
  name: string;
  value: number;
  unit: string;
  /** Index of the touched point. */
  point: number | null;
  /** The pose whose picture shows it, and where. */
  pose: number | null;
  at_px: [number, number] | null;
}

/** How far the point that a pixel shows moved between two calibrations. */
export interface MovedPoint {
  u: number;
  v: number;
  moved_um: number;
}

export interface Comparison {
  /** Name and time of the calibration compared with. */
  with_name: string;
  /** Largest and rms shift of points of the measuring volume in the flange frame. */
  max_um: number;
  rms_um: number;
  map: MovedPoint[];
}

export interface CalibrationResult {
  verdict: Quality;
  verdict_text: string;
  reprojection_rms_px: number;
  laser_plane_rms_um: number;
  alignment_rms_um: number;
  depth_range_mm: [number, number];
  probe_matrix: number[][];
  faces: FaceResult[];
  budget: BudgetRow[];
  total_um: number;
  worst: WorstPoint[];
  comparison: Comparison | null;
  distortion: number[];
  plane: PlaneKnown | null;
  /** Over the picture; empty in calibrations of older versions. */
  map: MapPoint[];
  poses: PoseRow[];
  /** The pose whose picture is shown first: its edges fit worst. */
  shown_pose: number;
  /** The limits that the verdict went by; null in calibrations of older versions. */
  good_um: number | null;
  usable_um: number | null;
}

/** Standard uncertainty of a plane swept straight across, k = 1. */
export interface PlaneKnown {
  angle_arcsec: number;
  offset_um: number;
}

/** Standard uncertainty of the point that a pixel shows, k = 1. */
export interface MapPoint {
  u: number;
  v: number;
  u_um: number;
  /** Within the depths that the stripe covered; elsewhere it is extrapolated. */
  inside: boolean;
}

/** What became of one pose. */
export interface PoseRow {
  number: number;
  used: boolean;
  /** Why it was left out. */
  reason: string;
  edges_rms_px: number;
  stripe_rms_px: number;
  off_um: number;
}

/** One pose: its picture with what was found in it, or why nothing was. */
export interface PosePicture {
  number: number;
  state: "taken" | "used" | "left_out" | "aside";
  /** Why it does not count; empty where it does. */
  note: string;
  /** GET address of the captured picture. */
  image_url: string;
  width_px: number;
  height_px: number;
  corners: ImageCorner[];
  outline: [number, number, number, number][];
  stripe: [number, number][];
  marks: ImageMark[];
  /** Of the result, where there is one. */
  edges_rms_px: number | null;
  stripe_rms_px: number | null;
  off_um: number | null;
  /** Sets it aside, or takes it back. */
  action: Action | null;
  /** Of a result: u, v of some of the stripe's points, and how far each lies off, px. */
  stripe_off: Vec3[];
}

/** What the large picture shows. */
export type Picture =
  | { kind: "devices"; devices: DeviceLine[] }
  | { kind: "choices"; choices: Choice[]; block: BlockGeometry | null }
  | { kind: "object"; block: BlockGeometry; faces: FaceProgress[]; points: TouchedPoint[] }
  | {
      kind: "camera";
      /** The object as it would look from the advised hold, for the first picture about so. */
      target: [number, number, number, number][];
    }
  | {
      kind: "still";
      poses: PosePicture[];
      /** The number of the pose to look at first. */
      shown: number;
    }
  | {
      kind: "result";
      result: CalibrationResult;
      /** A pose was set aside or taken back since. */
      stale: boolean;
      block: BlockGeometry;
      points: TouchedPoint[];
      poses: PosePicture[];
    };

/** The whole state of the guided flow, owned by the server. */
export interface FlowView {
  session_id: string;
  /** Grows with every change; commands carry it and a stale one gets 409. */
  rev: number;
  running: boolean;
  steps: Step[];
  step: string;
  title: string;
  instruction: string;
  picture: Picture;
  number: LiveNumber | null;
  progress: { done: number; of: number; text: string } | null;
  findings: Finding[];
  actions: Action[];
  /** A job or the hand at work: its words and its share done (0 to 1), else null. */
  busy: { text: string; fraction: number | null } | null;
}

export interface FlowCommand {
  name: string;
  args: Record<string, unknown>;
  rev: number;
  /** Idempotency key: the same key twice acts once. */
  key: string;
}

/** RFC 9457 */
export interface Problem {
  type: string;
  title: string;
  status: number;
  detail: string;
  /** machine-readable name */
  code: string;
  remedy: string;
  /** with 409 of a stale flow command */
  view?: FlowView;
}

export interface DeviceState {
  title: string;
  state: "connected" | "connecting" | "lost" | "off";
  text: string;
  /** Age of the newest data when this was sent. */
  age_s: number | null;
  rate_hz: number | null;
  received: number;
  lost: number;
  corrupt: number;
}

export interface Devices {
  arm: DeviceState;
  sensor: DeviceState;
  laser_on: boolean;
  has_laser_switch: boolean;
  arm_still: boolean;
  exposure_us: number | null;
  /** Tip centre in the arm frame, mm. */
  tip_mm: Vec3 | null;
  disk_free_gb: number;
}

export interface ScanState {
  state: "idle" | "running" | "stopping" | "blocked";
  /** Why a scan cannot start; empty when it can. */
  why_not: string;
  scan_id: string | null;
  points: number;
  points_shown: number;
  rate_points_s: number;
  frames: number;
  lost_frames: number;
  frames_without_joints: number;
  seconds: number;
  /** The way of the surface under the stripe during the newest exposure; null where none is seen. */
  blur_mm: number | null;
  /** From one stripe to the next: the points' spacing along the pass. */
  step_mm: number | null;
  blur_limit_mm: number | null;
  frames_too_fast: number;
  /** Recorded beside their stripes. */
  pictures: number;
  findings: Finding[];
  /** True while the twin's hand moves the sensor over the part. */
  hand_running: boolean;
}

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

/** How far a recording is that is shown again. */
export interface ReplayState {
  recording: string;
  /** 1 as it was taken; 0 as fast as it can be read. */
  speed: number;
  /** Of the recording's own time. */
  played_s: number;
  /** Null for a recording that was cut off. */
  length_s: number | null;
  points: number;
  points_shown: number;
  state: "playing" | "ended" | "failed";
  /** What became of it, once it has ended. */
  text: string;
}

/** Between the arm's clock and the camera's, as it was found. */
export interface Delay {
  delay_ms: number;
  standard_uncertainty_ms: number;
  rms_without_um: number;
  rms_um: number;
  /** Of which scan. */
  scan: string;
  applied: boolean;
}

/** What an operator sets of scans; null is automatic. */
export interface StationSettings {
  threshold: number | null;
  min_width_px: number | null;
  choice: "continuity" | "strength" | "first" | "last";
  exposure_us: number | null;
  /** Where nothing is measured: corners in pixels of the full frame. */
  zones: [number, number][][];
  blur_limit_mm: number | null;
  record_pictures: boolean;
  /** In use, or found and not yet used. */
  delay: Delay | null;
  finding_delay: boolean;
  findings: Finding[];
}

export interface ScanSummary {
  id: string;
  name: string;
  started_at: string;
  points: number;
  frames: number;
  seconds: number;
  calibration_id: string;
}

export interface Station {
  name: string;
  version: string;
  /** True on the twin: "let the hand do it" is offered. */
  has_hand: boolean;
  /** True where the devices are simulated. */
  simulated: boolean;
}

/** Home: what is valid, what is due, what to do next. */
export interface Home {
  station: Station;
  calibration: CalibrationSummary | null;
  checks: Validity[];
  /** Of the room, where somebody or a thermometer told it lately. */
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

/** Server to client over /api/live (JSON text frames). */
export type LiveMessage =
  | { type: "hello"; station: Station; you: You }
  | { type: "topic"; name: "control"; value: Control }
  | { type: "topic"; name: "devices"; value: Devices }
  | { type: "topic"; name: "flow"; value: FlowView }
  | { type: "topic"; name: "scan"; value: ScanState }
  | { type: "topic"; name: "settings"; value: StationSettings }
  | { type: "topic"; name: "replay"; value: ReplayState }
  | { type: "topic"; name: "home"; value: Home }
  | { type: "topic"; name: "arm"; value: ArmView }
  | { type: "topic"; name: "verify"; value: VerifyView }
  | { type: "topic"; name: "view"; value: ViewState }
  | { type: "event"; id: number; kind: string; quality: Quality; text: string }
  | { type: "beat" };

/** Client to server over /api/live. */
export type LiveRequest =
  | { type: "beat" }
  | { type: "preview"; on: boolean }
  | { type: "preview_ack"; seq: number };

/**
 * Server to client, binary: 4 bytes big-endian length of the header, the header as
 * UTF-8 JSON, then a JPEG. Sent only after the last one was acknowledged.
 */
export interface PreviewHeader {
  seq: number;
  width_px: number;
  height_px: number;
  age_s: number;
  /** Pixels of the full frame, whatever the JPEG's own size. */
  stripe: [number, number][];
  corners: ImageCorner[];
  outline: [number, number, number, number][];
  saturated_percent: number;
  laser_on: boolean;
  arm_still: boolean;
  findings: Finding[];
  /** Boxes in which the picture is saturated: left, top, width, height. */
  saturated: [number, number, number, number][];
  /** Where the laser's light falls at the ends of the calibrated distance. */
  band: Band | null;
  aids: Aid[];
}

/** Lines in the picture, empty where they lie outside it. */
export interface Band {
  near_mm: number;
  far_mm: number;
  near: [number, number][];
  far: [number, number][];
}

/** A figure with what is wanted; `words` is which way to go, empty where all is well. */
export interface Aid {
  name: "exposure" | "focus" | "framing" | "distance";
  title: string;
  value: number;
  unit: string;
  decimals: number;
  wanted: string;
  quality: Quality;
  words: string;
}
