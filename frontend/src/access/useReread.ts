import { useCallback, useEffect, useState } from "react";

import { tell } from "../api/commands";
import { get } from "../api/http";
import { t } from "../state/language";

/** A list of the station's, and how to read it anew after a change. */
export function useReread<T>(path: string): { list: T[] | null; reread: () => Promise<void> } {
  const [list, setList] = useState<T[] | null>(null);
  const reread = useCallback(async () => {
    try {
      setList(await get<T[]>(path));
    } catch (error) {
      tell(error, t("the list could not be read"));
    }
  }, [path]);
  useEffect(() => void reread(), [reread]);
  return { list, reread };
}
