import type { Quality } from "../api/types";
import { t } from "./language";
import { getState, setState } from "./store";

let next = 1;

/** Shows one sentence; with `lasts_ms`, it disappears automatically. */
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

/** The banner of an earlier action is removed when a later one succeeds. */
export function clearBanner(): void {
  setState({ banner: null });
}

/** The station responds again: an unconfirmed action only needs to be checked. */
export function noteReturn(): void {
  if (!getState().banner?.untilHeard) return;
  notify({ quality: "neutral", title: t("ui-station-responds-again-check-whether-last") }, 8000);
}

export function dismiss(id: number): void {
  if (getState().banner?.id === id) setState({ banner: null });
}
