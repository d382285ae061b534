import { useLive } from "./store";

/** Whether the arm has a probe to touch with: one that reports poses, such as a robot, has none. */
export function useProbe(): boolean {
  return useLive((s) => !s.home || s.home.checks.some(({ id }) => id === "tip"));
}
