import { useEffect, useState } from "react";

import { TRIAL_POINTS, trial_ms } from "./trial";

/** Thousands of cloud points that a browser receives, fewer with each step; all at first. */
const STEPS = [null, 300, 75] as const;
/** Share of the cloud points that the station shows. */
const MOST_POINTS = 2_000_000;
const KEY = "crenel-drawing";
const LOOKED_MS = 1500;
/** If rendering is slower than this, the buttons of the page wait for it. */
const SLOW_MS = 250;

/** A browser without a graphics processor cannot draw many points; if it does not say so, it is tested. */
function firstStep(): number {
  const stored = Number(sessionStorage.getItem(KEY));
  if (stored > 0 && stored < STEPS.length) return stored;
  const canvas = document.createElement("canvas");
  canvas.width = 1024;
  canvas.height = 768;
  const gl = canvas.getContext("webgl2");
  const named = gl?.getExtension("WEBGL_debug_renderer_info");
  const renderer = gl && named ? String(gl.getParameter(named.UNMASKED_RENDERER_WEBGL)) : "";
  const software = /swiftshader|llvmpipe|softpipe|software|basic render/i.test(renderer);
  const step = software ? STEPS.length - 1 : gl ? stepOf(trial_ms(gl)) : 0;
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return step;
}

/** The number that can be drawn within one slow frame, by the duration of the test. */
function stepOf(took_ms: number): number {
  const all = MOST_POINTS * (took_ms / TRIAL_POINTS);
  const some = 1000 * STEPS[1] * (took_ms / TRIAL_POINTS);
  return all < SLOW_MS ? 0 : some < SLOW_MS ? 1 : STEPS.length - 1;
}

let step: number | null = null;

/** How many thousand points to draw here, null for all; and a function that monitors rendering. */
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
        sessionStorage.setItem(KEY, `${step}`);
        setNow(step);
      }
    });
    return () => window.cancelAnimationFrame(request);
  }, [picture, now]);
  return { thousands: STEPS[now] ?? null, watch };
}
