/** What was filled in so far, kept in this tab of the browser until it is stored as a datasheet. */

import { useState } from "react";

import { typed } from "../controls/lengths";
import type { Instrument, InstrumentNumbers } from "./dimensions";

export interface TableFile {
  name: string;
  text: string;
}

export interface Draft {
  /** None of a block that is known by a table alone. */
  instrument: Instrument | "none";
  numbers: Record<Instrument, InstrumentNumbers>;
  /** By the faces of each dimension. */
  readings: Record<string, string>;
  points: TableFile | null;
  table: TableFile | null;
  arm: string;
  arm_um: string;
  tip_um: string;
  certificate: string;
}

const firstDraft = (arm: string): Draft => ({
  instrument: "calliper",
  numbers: {
    calliper: { resolution: typed(0.01, "mm"), uncertainty: typed(0.03, "mm") },
    micrometer: { resolution: typed(0.001, "mm"), uncertainty: typed(0.004, "mm") },
  },
  readings: {},
  points: null,
  table: null,
  arm,
  arm_um: "",
  tip_um: "",
  certificate: "",
});

/** The draft of a datasheet's version; it outlives a reload. */
export function useDraft(name: string, arm: string) {
  const key = `crenel-certificate ${name}`;
  const [draft, setDraft] = useState<Draft>(() => {
    const kept = sessionStorage.getItem(key);
    return { ...firstDraft(arm), ...(kept ? (JSON.parse(kept) as Partial<Draft>) : {}) };
  });
  const change = (changes: Partial<Draft>) => {
    const now = { ...draft, ...changes };
    setDraft(now);
    try {
      sessionStorage.setItem(key, JSON.stringify(now));
    } catch {
      /* the browser's storage is full: the form works all the same */
    }
  };
  return { draft, change, forget: () => sessionStorage.removeItem(key) };
}
