import { useEffect, useState } from "react";

import { get } from "../api/http";
import { useLive } from "./store";

/** The data at an address of the station, once somebody is signed in; reloaded when it is back, and on every
 * `change`. */
export function useRead<T>(path: string, change = ""): { value: T | null; failed: boolean } {
  const [value, setValue] = useState<T | null>(null);
  const [failed, setFailed] = useState(false);
  const live = useLive((s) => s.connection === "live");
  const signedIn = useLive((s) => Boolean(s.session?.you));
  // biome-ignore lint/correctness/useExhaustiveDependencies: reloaded with each of them
  useEffect(() => {
    if (!signedIn) return;
    let wanted = true;
    get<T>(path).then(
      (read) => {
        if (!wanted) return;
        setValue(read);
        setFailed(false);
      },
      () => wanted && setFailed(true),
    );
    return () => {
      wanted = false;
    };
  }, [path, live, change, signedIn]);
  return { value, failed };
}
