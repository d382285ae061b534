import { useEffect, useRef } from "react";

import { useLive } from "./store";

/** Calls back when a pose is requested from elsewhere on the page; not for earlier requests. */
export function useLook(onLook: (pose: number) => void): void {
  const look = useLive((s) => s.look);
  const last = useRef(look);
  const call = useRef(onLook);
  call.current = onLook;
  useEffect(() => {
    if (look === last.current) return;
    last.current = look;
    if (look) call.current(look.pose);
  }, [look]);
}
