import { useCallback, useEffect, useState } from "react";

import { notifyOfError } from "../api/commands";
import { get } from "../api/http";
import { t } from "../state/language";

/** A list from the station, and a function to reload it after a change. */
export function useReread<T>(path: string): { list: T[] | null; reread: () => Promise<void> } {
  const [list, setList] = useState<T[] | null>(null);
  const reread = useCallback(async () => {
    try {
      setList(await get<T[]>(path));
    } catch (error) {
      notifyOfError(error, t("ui-the-list-could-not-be-loaded"));
    }
  }, [path]);
  useEffect(() => void reread(), [reread]);
  return { list, reread };
}
