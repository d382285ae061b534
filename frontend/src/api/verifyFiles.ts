/** What is read of the server's own files; their formats stand in app/formats/results. */

import type { CloudLine, FigureLine, VerdictLine } from "./verifyTypes";

/** `verification.json` */
export interface VerificationRecord {
  id: string;
  station: string;
  operator: string;
  accepted_at: string;
  gauge: { shape: "plane" | "sphere"; name: string; serial_number: string; certificate: string; radius_mm?: number };
  serial_numbers: { arm: string; object: string; sensor: string };
  calibration: { id: string; name: string };
  placing?: { touches: number; rms_um: number };
  clouds: (Partial<CloudLine> & { name: string; recording: string; points: number; used: number })[];
  figures: (Omit<FigureLine, "limit" | "clouds"> & { limit?: number; clouds?: number[] })[];
  verdict: VerdictLine & { reasons: string[] };
  notes: string[];
  temperature: { start_c?: number; end_c?: number };
}

/** `study.json`: each cloud with each calibration. */
export interface StudyFile {
  shape: "plane" | "sphere";
  against_probe: boolean;
  clouds: string[];
  calibrations: string[];
  calibration_ids: string[];
  rows: {
    cloud: number;
    calibration: number;
    rms_um: number;
    angle_arcsec?: number;
    z_error_um?: number;
    radius_error_um?: number;
    centre_error_um?: number;
  }[];
  between_clouds: { of: number; first: number; second: number }[];
  between_calibrations: { of: number; first: number; second: number }[];
  left_out: string[];
}

/** `map.json` */
export interface MapFile {
  cell_mm: number;
  x_mm: number[];
  y_mm: number[];
  deviation_um: number[];
}
