import { Interest } from "./interest";

/** Interest in other stations. */
export const stationsInterest = new Interest<symbol>();

/** Subscribes to other stations while mounted. */
export function watchStations(): () => void {
  return stationsInterest.watch(Symbol("page"));
}
