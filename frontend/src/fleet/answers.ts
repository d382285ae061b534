import { useEffect, useState } from "react";

import { get, Refused } from "../api/http";
import { readSession } from "../api/session";
import type { Quality } from "../api/types";
import type { PlainId } from "../messages/text";

export const KINDS: Record<string, PlainId> = {
  scan: "ui-fleet-kind-scan",
  calibration: "ui-calibration",
  verification: "ui-verification",
  performance: "ui-fleet-kind-performance",
  arm_check: "ui-arm-check",
  tip_check: "ui-tip-check",
  session: "ui-fleet-session",
};

const QUALITIES: Record<string, Quality> = {
  pass: "good",
  good: "good",
  fail: "bad",
  bad: "bad",
  uncertain: "attention",
  attention: "attention",
};

/** How a verdict or a decision is marked. */
export function qualityOf(verdict: string): Quality {
  return QUALITIES[verdict] ?? "neutral";
}

/** With how many decimals a unit is shown. */
export function decimalsOf(unit: string): number {
  return { mm: 3, px: 2 }[unit] ?? 1;
}

/** The data at an address, read again at intervals; the last answer stays while there is none. An empty address is not read. */
export function useAnswer<T>(path: string, every_ms = 0): { value: T | null; failed: boolean } {
  const [value, setValue] = useState<T | null>(null);
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    if (!path) return;
    let wanted = true;
    const read = () =>
      get<T>(path).then(
        (answer) => {
          if (!wanted) return;
          setValue(answer);
          setFailed(false);
        },
        (error) => {
          if (!wanted) return;
          setFailed(true);
          if (error instanceof Refused && error.problem.code === "signed-out") void readSession();
        },
      );
    void read();
    const timer = every_ms > 0 ? setInterval(read, every_ms) : undefined;
    return () => {
      wanted = false;
      clearInterval(timer);
    };
  }, [path, every_ms]);
  return { value, failed };
}
