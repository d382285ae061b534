import { useEffect, useState } from "react";

import { get } from "../api/http";
import { useLive } from "./store";

interface Read<T> {
  path: string;
  value: T | null;
  failed: boolean;
}

/** The data at an address of the station, once somebody is signed in; null until they have been read. Reloaded
 * when the station is back, and on every `change`: until then, and if that fails, the former data stay. An empty
 * address is not read. */
export function useRead<T>(path: string, change = ""): { value: T | null; failed: boolean } {
  const [read, setRead] = useState<Read<T>>({ path: "", value: null, failed: false });
  const live = useLive((s) => s.connection === "live");
  const signedIn = useLive((s) => Boolean(s.session?.you));
  // biome-ignore lint/correctness/useExhaustiveDependencies: reloaded with each of them
  useEffect(() => {
    if (!signedIn || !path) return;
    let wanted = true;
    get<T>(path).then(
      (value) => wanted && setRead({ path, value, failed: false }),
      () => wanted && setRead((before) => ({ path, value: before.path === path ? before.value : null, failed: true })),
    );
    return () => {
      wanted = false;
    };
  }, [path, live, change, signedIn]);
  return read.path === path ? read : { value: null, failed: false };
}
