import type { Quality } from "../api/types";
import { t } from "./language";
import { getState, setState } from "./store";

let next = 1;

/** Shows one sentence; with `lasts_ms` it leaves by itself. */
export function notify(
  banner: { quality: Quality; title: string; detail?: string; remedy?: string; untilHeard?: boolean },
  lasts_ms?: number,
): void {
  const id = next++;
  setState({
    banner: {
      id,
      quality: banner.quality,
      title: banner.title,
      detail: banner.detail ?? "",
      remedy: banner.remedy ?? "",
      untilHeard: banner.untilHeard ?? false,
    },
  });
  if (lasts_ms) setTimeout(() => dismiss(id), lasts_ms);
}

/** A banner of an earlier act is over once a later one has succeeded. */
export function clearBanner(): void {
  setState({ banner: null });
}

/** The station is heard again: an act that it did not confirm is to be looked at, no more. */
export function noteReturn(): void {
  if (!getState().banner?.untilHeard) return;
  notify({ quality: "neutral", title: t("ui-station-responds-again-check-whether-last") }, 8000);
}

export function dismiss(id: number): void {
  if (getState().banner?.id === id) setState({ banner: null });
}
