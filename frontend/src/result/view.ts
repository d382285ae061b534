import type { Picture } from "../api/types";

/** A result as it is looked at. */
export type ResultView = Extract<Picture, { kind: "result" }>;
