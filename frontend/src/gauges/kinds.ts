import type { PerformanceView } from "../api/wire";
import { contact } from "./contact/kind";
import { lengths } from "./length/kind";
import { plane } from "./plane/kind";
import type { Kind } from "./session/kind";
import { sphere } from "./sphere/kind";

export type KindName = PerformanceView["test"];

/** The kinds of performance tests, in the order in which they are offered. */
export const KINDS: Record<KindName, Kind> = { sphere, lengths, plane, contact };
