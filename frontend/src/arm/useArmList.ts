import { useLive } from "../state/store";
import { useList } from "../state/useList";

/** What arm sessions recorded, newest first; read again with each step of a session. */
export function useArmList<T>(name: "checks" | "tips" | "identifications"): { list: T[] | null; failed: boolean } {
  const grown = useLive((s) => `${s.arm?.session_id ?? ""} ${s.arm?.step ?? ""}`);
  return useList<T>(`/api/arm/${name}`, grown);
}
