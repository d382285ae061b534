import { useEffect, useState } from "react";

import { get } from "../api/http";
import type { Quality } from "../api/types";
import type { RemoteStation } from "../api/wire";
import type { PlainId } from "../messages/text";

/** What the fleet's server answers; app/server/fleet/application.py defines it. */
export interface CatalogueStation {
  id: string;
  name: string;
  collected_at: string | null;
  problem: string;
  records: number;
  archived: number;
  size_bytes: number;
  newest_at: string | null;
}

export interface Overview {
  place: string;
  stations: CatalogueStation[];
  kinds: string[];
  quantities: string[];
  problem: string;
}

export interface OnBroker {
  broker: boolean;
  stations: RemoteStation[];
}

export interface Figure {
  symbol: string;
  quantity: string;
  value: number;
  unit: string;
  expanded_uncertainty: number | null;
  limit: number | null;
  decision: string;
}

export interface Entry {
  station: string;
  kind: string;
  id: string;
  at: string;
  label: string;
  operator: string;
  arm_serial: string;
  sensor_serial: string;
  object_serial: string;
  calibration_id: string;
  software: string;
  verdict: string;
  temperature_c: number | null;
  points: number | null;
  archived_at: string | null;
  place: string;
  size_bytes: number;
  files: { path: string; bytes: number; sha256: string }[];
  figures: Figure[];
}

export type Found = Entry & { key: number };

export interface DriftPoint {
  at: string;
  value: number;
  unit: string;
  limit: number | null;
  decision: string;
  record_key: number;
}

export interface DriftChange {
  after: string;
  by: string;
  earliest: string;
  latest: string;
  before_value: number;
  after_value: number;
  standard_uncertainty: number;
}

export interface Period {
  station: string;
  change: DriftChange;
  ended: DriftChange | null;
  calibration_ids: string[];
  recordings: Entry[];
  possible: Entry[];
}

export interface Drift {
  stations: { station: string; points: DriftPoint[]; changes: DriftChange[] }[];
  periods: Period[];
}

export const KINDS: Record<string, PlainId> = {
  scan: "ui-scan",
  calibration: "ui-calibration",
  verification: "ui-verification",
  performance: "ui-performance",
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

/** The data at an address, read again at intervals; the last answer stays while there is none. */
export function useAnswer<T>(path: string, every_ms = 0): { value: T | null; failed: boolean } {
  const [value, setValue] = useState<T | null>(null);
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    let wanted = true;
    const read = () =>
      get<T>(path).then(
        (answer) => {
          if (!wanted) return;
          setValue(answer);
          setFailed(false);
        },
        () => wanted && setFailed(true),
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
