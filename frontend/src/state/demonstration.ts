import { useEffect } from "react";

import { done } from "../api/commands";
import { post } from "../api/http";
import { t } from "./language";
import { go } from "./router";
import { getState, useLive } from "./store";

/** Whether this browser began the demonstration, and goes where there is something to see. */
let follows = false;

export async function startDemonstration(): Promise<void> {
  follows = true;
  follows = await done(() => post("/api/demonstration"), t("ui-the-demonstration-was-not-started"));
}

export async function stopDemonstration(): Promise<void> {
  await done(() => post("/api/demonstration/stop"), t("ui-the-demonstration-may-still-run"));
}

/** Shows each part of the demonstration when it begins; in between, other pages can be opened. */
export function useDemonstration(): void {
  const page = useLive((s) => (s.demonstration?.running ? s.demonstration.page : null));
  useEffect(() => {
    if (page && follows) go(page);
    return () => {
      // it goes on with the next part, unless this was the last one
      if (page) follows = follows && getState().demonstration?.running === true;
    };
  }, [page]);
}
