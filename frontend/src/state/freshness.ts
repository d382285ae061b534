import { useEffect, useState } from "react";

import { getState, useLive } from "./store";

/** Seconds since the last message of the station, updated four times a second while it is lost. */
export function useSilence(): { live: boolean; silent_s: number } {
  const connection = useLive((s) => s.connection);
  const [silent_s, setSilent] = useState(0);
  const live = connection === "live";
  useEffect(() => {
    if (live) return;
    const look = () => setSilent((performance.now() - getState().heardAt) / 1000);
    look();
    const timer = setInterval(look, 250);
    return () => clearInterval(timer);
  }, [live]);
  return { live, silent_s: live ? 0 : silent_s };
}

/** Whole and tenth seconds since `since` (performance.now()), while `running`. */
export function useElapsed(running: boolean): number {
  const [elapsed_s, setElapsed] = useState(0);
  useEffect(() => {
    if (!running) return;
    const start = performance.now();
    setElapsed(0);
    const timer = setInterval(() => setElapsed((performance.now() - start) / 1000), 200);
    return () => clearInterval(timer);
  }, [running]);
  return running ? elapsed_s : 0;
}
