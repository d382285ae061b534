/** The guided calibration. The Python side of each shape is in app/guide/common/view.py. */

import type { CalibrationResult, PosePicture } from "./resultTypes";
import type { Action, ChoiceOption, Finding, LiveNumber, Quality, Step, Vec3 } from "./types";

/** The crenellated block's geometry for drawing, in mm, from its certificate. */
export interface BlockGeometry {
  kind: "block";
  edges_x_mm: number[];
  front_y_mm: number;
  back_y_mm: number;
  crest_z_mm: number;
  floor_z_mm: number;
  base_z_mm: number;
}

/**
 * A flat chessboard: the origin is the first inner corner, X runs along the rows of corners,
 * Y along the columns, Z out of the board toward the viewer.
 */
export interface BoardGeometry {
  kind: "board";
  /** Columns and rows. */
  inner_corners: [number, number];
  square_mm: number;
}

/** What the sensor is calibrated on. */
export type ObjectGeometry = BlockGeometry | BoardGeometry;

/** A touched point on the object. */
export interface TouchedPoint {
  index: number;
  face: string;
  /** Where it lies on the object (object frame, mm), null until it is known. */
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

/** What the large picture shows. */
export type Picture =
  | { kind: "devices"; devices: DeviceLine[] }
  | { kind: "choices"; choices: Choice[]; object: ObjectGeometry | null }
  | { kind: "object"; object: ObjectGeometry; faces: FaceProgress[]; points: TouchedPoint[] }
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
      /** A pose was excluded or included since. */
      stale: boolean;
      object: ObjectGeometry;
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
  /** The running job, or the simulated operator: its text and its share done (0 to 1), else null. */
  busy: { text: string; fraction: number | null } | null;
}

export interface FlowCommand {
  name: string;
  args: Record<string, unknown>;
  rev: number;
  /** Idempotency key: the same key twice acts once. */
  key: string;
}
