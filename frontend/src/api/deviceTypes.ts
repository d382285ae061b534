/** The devices, and the live picture with its detections. The Python side of each shape is in app/station. */

import type { ImageCorner } from "./resultTypes";
import type { Finding, Quality, Vec3 } from "./types";

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
