import type { Quality } from "../api/types";
import { getState, setState } from "./store";

let next = 1;

/** Shows one sentence; with `lasts_ms` it leaves by itself. */
export function notify(
  notice: { quality: Quality; title: string; detail?: string; remedy?: string },
  lasts_ms?: number,
): void {
  const id = next++;
  setState({
    notice: {
      id,
      quality: notice.quality,
      title: notice.title,
      detail: notice.detail ?? "",
      remedy: notice.remedy ?? "",
    },
  });
  if (lasts_ms) setTimeout(() => dismiss(id), lasts_ms);
}

/** What was told of an earlier act is over once a later one has succeeded. */
export function clearNotice(): void {
  setState({ notice: null });
}

export function dismiss(id: number): void {
  if (getState().notice?.id === id) setState({ notice: null });
}
