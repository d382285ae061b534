import STOPS from "./deviationStops.json";

/** The station's scale of deviations, by stops at equal distances: blue inside, grey where it fits, orange outside. */
const COLOURS = STOPS.map((stop) => [1, 3, 5].map((at) => Number.parseInt(stop.slice(at, at + 2), 16)));

/** The colour of a deviation, as a share of the end of the scale. */
export function deviationColour(share: number): string {
  const place = ((Math.max(-1, Math.min(1, share)) + 1) / 2) * (COLOURS.length - 1);
  const i = Math.min(COLOURS.length - 2, Math.floor(place));
  const [low, high] = [COLOURS[i] ?? [], COLOURS[i + 1] ?? []];
  const mix = low.map((value, k) => Math.round(value + ((high[k] ?? value) - value) * (place - i)));
  return `rgb(${mix.join(" ")})`;
}

export const DEVIATION_CSS = `linear-gradient(90deg, ${STOPS.join(", ")})`;
