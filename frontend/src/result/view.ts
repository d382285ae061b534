import type { Picture } from "../api/flowTypes";

/** A result as it is looked at. */
export type ResultView = Extract<Picture, { kind: "result" }>;
