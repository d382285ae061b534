/** Scans, and replayed recordings. The Python side of each shape is in app/wire/schema.py and app/server/live_replay.py. */

import type { Finding } from "./types";

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
  /** The way of the surface under the stripe during the newest exposure; null where none is visible. */
  blur_mm: number | null;
  /** From one stripe to the next: the points' spacing along the pass. */
  step_mm: number | null;
  blur_limit_mm: number | null;
  frames_too_fast: number;
  /** Recorded beside their stripes. */
  pictures: number;
  findings: Finding[];
  /** True while the simulated operator moves the sensor over the part. */
  hand_running: boolean;
}

/** How far a replayed recording is. */
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

export interface ScanSummary {
  id: string;
  name: string;
  started_at: string;
  points: number;
  frames: number;
  seconds: number;
  calibration_id: string;
  /** What is wrong with its recording, or why it ended early; mostly empty. */
  note: string;
}
