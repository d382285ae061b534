/** What all of the station's answers are made of. The Python side of each shape is named in tests/api/test_types.py. */

import type { FlowView } from "./flowTypes";

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
  /** Why it is not possible now; displayed next to the disabled button. */
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

export interface ChoiceOption {
  id: string;
  label: string;
  detail: string;
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
