import { useEffect, useRef, useState } from "react";

import type { Heading } from "./view";

const TURN_MS = 420;

const still = window.matchMedia("(prefers-reduced-motion: reduce)");

/** The heading on its way to `wanted`, along the shorter rotation. */
export function useHeading(wanted: Heading): Heading {
  const [heading, setHeading] = useState(wanted);
  const from = useRef(wanted);
  const { azimuth_deg, elevation_deg } = wanted;

  useEffect(() => {
    const start = from.current;
    const turn = ((azimuth_deg - start.azimuth_deg + 540) % 360) - 180;
    const rise = elevation_deg - start.elevation_deg;
    if (turn === 0 && rise === 0) return;
    const began = performance.now();
    let request = 0;
    const step = (now: number) => {
      const t = still.matches ? 1 : Math.min(1, Math.max(0, (now - began) / TURN_MS));
      const eased = t * t * (3 - 2 * t);
      from.current = {
        azimuth_deg: start.azimuth_deg + turn * eased,
        elevation_deg: start.elevation_deg + rise * eased,
      };
      setHeading(from.current);
      if (t < 1) request = requestAnimationFrame(step);
    };
    request = requestAnimationFrame(step);
    return () => cancelAnimationFrame(request);
  }, [azimuth_deg, elevation_deg]);

  return heading;
}
