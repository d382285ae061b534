import { useLive } from "./store";
import { useRead } from "./useRead";

/**
 * A list of the station's records, read again when the station's own state, or `change`, indicates
 * that it may have grown.
 */
export function useList<T>(path: string, change = ""): { list: T[] | null; failed: boolean } {
  const grown = useLive((s) => `${s.home?.calibration?.id ?? ""} ${s.scan?.state ?? ""}`);
  const { value, failed } = useRead<T[]>(path, `${grown} ${change}`);
  return { list: value, failed };
}
