import { useCallback, useEffect, useState } from "react";

import { endTrial, readDevices, readTrial, searchDevices } from "../api/deviceCommands";
import type { DevicesView, TrialView } from "../api/wire";
import { useLive } from "../state/store";

const SEARCHING_MS = 400;
const RESTING_MS = 1500;
const TRIAL_MS = 200;

/** The devices in use and those found; the search begins when the page opens. */
export function useDevices(): [DevicesView | null, (view: DevicesView | null) => void] {
  const live = useLive((s) => s.connection === "live");
  const [view, setView] = useState<DevicesView | null>(null);
  const put = useCallback((next: DevicesView | null) => next && setView(next), []);
  useEffect(() => void searchDevices().then(put), [put]);
  const period_ms = view?.searching ? SEARCHING_MS : RESTING_MS;
  useEffect(() => {
    if (!live) return;
    const timer = setInterval(() => void readDevices().then(put, () => undefined), period_ms);
    return () => clearInterval(timer);
  }, [live, period_ms, put]);
  return [view, put];
}

/** The device that is tried, looked at again and again, which keeps it open; closed with the page. */
export function useTrial(on: boolean, first: TrialView | null): TrialView | null {
  const [trial, setTrial] = useState(first);
  useEffect(() => setTrial(first), [first]);
  useEffect(() => {
    if (!on) return;
    let over = false;
    let timer = 0;
    const look = async () => {
      try {
        const now = await readTrial();
        if (!over && now) setTrial(now);
      } catch {
        // the lost connection has its own banner
      }
      if (!over) timer = window.setTimeout(look, TRIAL_MS);
    };
    timer = window.setTimeout(look, TRIAL_MS);
    return () => {
      over = true;
      clearTimeout(timer);
      void endTrial();
    };
  }, [on]);
  return trial;
}
