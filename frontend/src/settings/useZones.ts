import { useState } from "react";

import { changeSettings } from "../api/settingsCommands";
import type { StationSettings } from "../api/wire";

export type Zone = [number, number][];

export interface Zones {
  drawing: boolean;
  setDrawing: (on: boolean) => void;
  set: (zones: Zone[]) => Promise<void>;
  undo: () => Promise<void>;
  canUndo: boolean;
}

/** Changes of the zones, each applied at once, with undo. */
export function useZones(settings: StationSettings | null): Zones {
  const [drawing, setDrawing] = useState(false);
  const [before, setBefore] = useState<Zone[][]>([]);
  const current = settings?.zones ?? [];
  const set = async (zones: Zone[]) => {
    setDrawing(false);
    if (await changeSettings({ zones })) setBefore([...before, current]);
  };
  const undo = async () => {
    const last = before[before.length - 1];
    if (last && (await changeSettings({ zones: last }))) setBefore(before.slice(0, -1));
  };
  return { drawing, setDrawing, set, undo, canUndo: before.length > 0 };
}
