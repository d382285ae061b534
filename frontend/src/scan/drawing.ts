import { useEffect, useState } from "react";

/** Thousands of the clouds' points that a browser is sent, fewer with each step; at first all. */
const STEPS = [null, 300, 75] as const;
const KEPT = "crenel-drawing";
const LOOKED_MS = 3000;
/** Slower than this, the page's buttons wait for the picture. */
const SLOW_MS = 250;

/** A browser without a graphics processor cannot draw many. */
function firstStep(): number {
  const kept = Number(sessionStorage.getItem(KEPT));
  if (kept > 0 && kept < STEPS.length) return kept;
  const gl = document.createElement("canvas").getContext("webgl");
  const named = gl?.getExtension("WEBGL_debug_renderer_info");
  const renderer = gl && named ? String(gl.getParameter(named.UNMASKED_RENDERER_WEBGL)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(renderer) ? STEPS.length - 1 : 0;
}

let step: number | null = null;

/** How many thousand points are to be drawn here, null for all; and what watches the picture. */
export function useDrawing(): { thousands: number | null; watch: (picture: { window: Window }) => void } {
  const [now, setNow] = useState(() => (step ??= firstStep()));
  const [picture, watch] = useState<{ window: Window } | null>(null);
  useEffect(() => {
    if (!picture || now === STEPS.length - 1) return;
    const { window } = picture;
    let frames = 0;
    let slow = 0;
    let began = performance.now();
    let request = window.requestAnimationFrame(function drawn(): void {
      frames += 1;
      const gone = performance.now() - began;
      const each = gone / frames;
      if (gone > LOOKED_MS) {
        slow = !document.hidden && each > SLOW_MS ? slow + 1 : 0;
        frames = 0;
        began = performance.now();
      }
      if (slow < 2) request = window.requestAnimationFrame(drawn);
      else {
        step = each > 4 * SLOW_MS ? STEPS.length - 1 : now + 1;
        sessionStorage.setItem(KEPT, `${step}`);
        setNow(step);
      }
    });
    return () => window.cancelAnimationFrame(request);
  }, [picture, now]);
  return { thousands: STEPS[now] ?? null, watch };
}
