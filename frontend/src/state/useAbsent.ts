import { useLive } from "./store";

/** That the station has no such device, which somebody must choose; empty where it has them all. */
export function useAbsent(...kinds: ("arm" | "sensor")[]): string {
  return useLive((s) => kinds.map((kind) => s.devices?.[kind]).find((one) => one?.state === "absent")?.text ?? "");
}
