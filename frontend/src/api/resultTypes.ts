/** A calibration's result and its pictures. The Python side of each shape is in app/guide/common/result_view.py and app/guide/common/view.py. */

import type { Action, Quality, Vec3 } from "./types";

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
  /** Null where the object was not touched. */
  alignment_rms_um: number | null;
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
  /** The pose whose picture is displayed first: its edges fit worst. */
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
  /** Why it, or its laser line, was left out. */
  reason: string;
  edges_rms_px: number;
  /** Null without a laser line. */
  stripe_rms_px: number | null;
  off_um: number;
}

/** One pose: its picture with what was found in it, or why nothing was. */
export interface PosePicture {
  number: number;
  state: "taken" | "used" | "left_out" | "aside";
  /** Why it, or its laser line, does not count; empty where both do. */
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
  /** Excludes it, or includes it again. */
  action: Action | null;
  /** Of a result: u, v of some of the stripe's points, and how far each lies off, px. */
  stripe_off: Vec3[];
}
