import type { Picture } from "../api/types";

/** The view of a result. */
export type ResultView = Extract<Picture, { kind: "result" }>;
