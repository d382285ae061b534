import type { TouchedPoint } from "../api/wire";
import { roundEnd } from "../controls/lengths";

/** The end of the scale in µm: a round number that includes every point except outliers. */
export function scaleEnd(points: TouchedPoint[]): number {
  const sizes = points.filter((p) => !p.outlier).map((p) => Math.abs(p.residual_um ?? 0));
  const largest = Math.max(0, ...sizes);
  return roundEnd(largest, "µm", 10, 1000);
}
