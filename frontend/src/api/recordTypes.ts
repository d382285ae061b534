import type { ResultView } from "../result/view";
import type { CalibrationSummary } from "./homeTypes";
import type { Finding, Quality } from "./types";

/** An accepted calibration, the result as it was looked at; empty texts where not written down. */
export interface RecordedCalibration {
  summary: CalibrationSummary;
  operator: string;
  station: string;
  temperature_c: number | null;
  picture: ResultView;
  findings: Finding[];
}

/** One calibration of the history, and what moved since the one before of the same arm and sensor. */
export interface CalibrationPoint {
  id: string;
  name: string;
  accepted_at: string;
  total_um: number;
  verdict: Quality;
  good_um: number | null;
  temperature_c: number | null;
  arm_serial: string;
  sensor_serial: string;
  sensor_um: number | null;
  sensor_arcsec: number | null;
  plane_um: number | null;
  plane_arcsec: number | null;
  points_um: number | null;
  /** What the uncertainties of both let expect of a sensor that did not move, k = 2. */
  expected_um: number | null;
  expected_arcsec: number | null;
}
