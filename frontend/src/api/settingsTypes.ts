/** What an operator sets. The Python side of each shape is in app/station/operator_settings.py. */

import type { Finding } from "./types";

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
