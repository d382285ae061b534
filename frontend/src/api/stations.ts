import { Interest } from "./interest";

/** In what other stations do. */
export const stationsInterest = new Interest<symbol>();

/** Asks for what other stations do while mounted. */
export function watchStations(): () => void {
  return stationsInterest.watch(Symbol("page"));
}
