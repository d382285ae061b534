import { useEffect, useState } from "react";

import { get } from "../api/http";
import { useLive } from "./store";

/**
 * A list of the station's records, read again when the station's own state, or `change`, says
 * that it may have grown.
 */
export function useList<T>(path: string, change = ""): { list: T[] | null; failed: boolean } {
  const [list, setList] = useState<T[] | null>(null);
  const [failed, setFailed] = useState(false);
  const live = useLive((s) => s.connection === "live");
  const grown = useLive((s) => `${s.home?.calibration?.id ?? ""} ${s.scan?.state ?? ""}`);
  useEffect(() => {
    let wanted = true;
    get<T[]>(path).then(
      (read) => {
        if (!wanted) return;
        setList(read);
        setFailed(false);
      },
      () => wanted && setFailed(true),
    );
    return () => {
      wanted = false;
    };
  }, [path, live, grown, change]);
  return { list, failed };
}
