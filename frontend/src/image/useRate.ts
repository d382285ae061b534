import { useCallback, useRef, useState } from "react";

const OVER_MS = 2000;

/** Events per second, over the last two seconds. */
export function useRate(): { rate: number; count: () => void } {
  const stamps = useRef<number[]>([]);
  const [rate, setRate] = useState(0);
  const count = useCallback(() => {
    const now = performance.now();
    stamps.current = [...stamps.current.filter((at) => now - at < OVER_MS), now];
    const first = stamps.current[0] ?? now;
    if (now > first) setRate(((stamps.current.length - 1) * 1000) / (now - first));
  }, []);
  return { rate, count };
}
