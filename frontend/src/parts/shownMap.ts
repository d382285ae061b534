import type { ShownMap } from "../api/wire";
import { type LiveState, useLive } from "../state/store";

/** The map in the 3D view; null while it shows clouds. */
export const shownMapOf = ({ compare, view }: LiveState): ShownMap | null => {
  const shown = compare?.shown ?? null;
  return shown && view?.surface_of === shown.result.scan ? shown : null;
};

export const useShownMap = () => useLive(shownMapOf);
