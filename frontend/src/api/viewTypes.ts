/** What the 3D view shows. The Python side of each shape is in app/station. */

/** What the clouds' colours mean. */
export interface Legend {
  measure: "height" | "intensity" | "uncertainty" | "age" | "deviation";
  unit: string;
  low: number;
  high: number;
  automatic: boolean;
  /** Of the scale, evenly spaced from low to high. */
  colours: string[];
}

/** A scan in the picture, and how much of it has been read, 0 to 1. */
export interface ShownScan {
  id: string;
  points_shown: number;
  loaded: number;
}

/** A number with its standard uncertainty, k = 1; null where it is not known. */
export interface Figure {
  label: string;
  value: number;
  unit: string;
  decimals: number;
  uncertainty: number | null;
  uncertainty_unit: string;
}

/** A shape fitted to a picked region. */
export interface Fitted {
  id: number;
  shape: "plane" | "sphere" | "cylinder";
  /** That the fit used. */
  points: number;
  /** That lie in the region. */
  picked: number;
  /** From all points of the scans, and not only those that are displayed. */
  every: boolean;
  rms_um: number;
  largest_um: number;
  form_um: number;
  figures: Figure[];
}

/** Of the stripe from the camera, against the calibrated range. */
export interface Distance {
  mm: number;
  near_mm: number;
  far_mm: number;
  state: "in" | "near" | "far";
}

export interface ViewState {
  scans: ShownScan[];
  measure: "height" | "intensity" | "uncertainty" | "age" | "deviation";
  /** Null before there is anything to colour. */
  legend: Legend | null;
  fits: Fitted[];
  /** What is being fitted now; empty when nothing is. */
  busy: string;
  distance: Distance | null;
  /** Counts up when scans were renamed or deleted. */
  records: number;
}

export type Measure = ViewState["measure"];
export type ShapeName = Fitted["shape"];

/** Shares of the 3D view, 0 to 1 from its left and from its top. */
export type Region = { left: number; top: number; right: number; bottom: number };
