import { useEffect, useState } from "react";

import { get, Refused } from "../api/http";
import { readSession } from "../api/session";
import type { Quality } from "../api/types";
import { figures } from "../controls/format";
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

/** A size in the larger of both units that it reaches. */
export function sizeOf(bytes: number): string {
  return bytes < 1e9 ? `${figures(bytes / 1e6, 1)} MB` : `${figures(bytes / 1e9, 1)} GB`;
}

/** With how many decimals a unit is shown. */
export function decimalsOf(unit: string): number {
  return { mm: 3, px: 2 }[unit] ?? 1;
}

const AGAIN_MS = 5000;

interface Answer<T> {
  value: T | null;
  /** The last reading failed; it is tried again. */
  failed: boolean;
  /** The value is that of an earlier address. */
  waiting: boolean;
}

/** The data at an address, read again at intervals; the last answer stays while there is none. An empty address is not read. */
export function useAnswer<T>(path: string, every_ms = 0): Answer<T> {
  const [read, setRead] = useState<{ path: string; value: T | null }>({ path: "", value: null });
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    if (!path) return;
    let wanted = true;
    let again: ReturnType<typeof setTimeout> | undefined;
    const look = () =>
      get<T>(path).then(
        (value) => {
          if (!wanted) return;
          setRead({ path, value });
          setFailed(false);
        },
        (error) => {
          if (!wanted) return;
          setFailed(true);
          if (error instanceof Refused && error.problem.code === "signed-out") void readSession();
          if (every_ms === 0) again = setTimeout(look, AGAIN_MS);
        },
      );
    void look();
    const timer = every_ms > 0 ? setInterval(look, every_ms) : undefined;
    return () => {
      wanted = false;
      clearInterval(timer);
      clearTimeout(again);
    };
  }, [path, every_ms]);
  return { value: read.value, failed, waiting: read.path !== path };
}
