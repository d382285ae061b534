import { type RefObject, useEffect } from "react";

/** A press that moves farther, or lasts longer, turns the picture. */
const MOVED_PX = 8;
const LASTS_MS = 800;

/** Calls back with the place of a tap on the 3D view, as shares of its width and height. */
export function useMapTap(
  frame: RefObject<HTMLIFrameElement | null>,
  active: boolean,
  onTap: (x: number, y: number) => void,
): void {
  useEffect(() => {
    const picture = frame.current;
    if (!picture || !active) return;
    let from: { x: number; y: number; at: number } | null = null;
    let page: Window | null = null;
    const down = (event: PointerEvent) => {
      from = event.isPrimary && event.button === 0 ? { x: event.clientX, y: event.clientY, at: event.timeStamp } : null;
    };
    const up = (event: PointerEvent) => {
      const start = from;
      from = null;
      if (!start || !page || !event.isPrimary || event.timeStamp - start.at > LASTS_MS) return;
      if (Math.hypot(event.clientX - start.x, event.clientY - start.y) > MOVED_PX) return;
      onTap(event.clientX / page.innerWidth, event.clientY / page.innerHeight);
    };
    // its own page takes pointers for itself: they are seen before it has them
    const leave = () => {
      page?.removeEventListener("pointerdown", down, true);
      page?.removeEventListener("pointerup", up, true);
    };
    const enter = () => {
      leave();
      page = picture.contentWindow;
      page?.addEventListener("pointerdown", down, true);
      page?.addEventListener("pointerup", up, true);
    };
    enter();
    picture.addEventListener("load", enter);
    return () => {
      picture.removeEventListener("load", enter);
      leave();
    };
  }, [frame, active, onTap]);
}
