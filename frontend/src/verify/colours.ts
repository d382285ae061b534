import { roundEnd } from "../parts/lengths";

/** Blue below, grey where it fits, orange above: suitable for colour-blind users, in both themes. */
const BELOW: [number, number, number] = [30, 100, 210];
const FITS: [number, number, number] = [202, 206, 212];
const ABOVE: [number, number, number] = [232, 120, 20];

export function deviationColour(share: number): string {
  const size = Math.min(1, Math.abs(share));
  const end = share < 0 ? BELOW : ABOVE;
  return `rgb(${FITS.map((value, k) => Math.round(value + ((end[k] ?? value) - value) * size)).join(" ")})`;
}

export const DEVIATION_CSS = `linear-gradient(90deg, ${[-1, -0.5, 0, 0.5, 1].map(deviationColour).join(", ")})`;

/** The end of the scale in µm: a round number that includes all cells except a few. */
export function deviationScale(values: number[]): number {
  const sizes = values.map(Math.abs).sort((a, b) => a - b);
  const most = sizes[Math.floor(0.98 * (sizes.length - 1))] ?? 0;
  return roundEnd(most, "µm", 5, 1000);
}
