import type { TrialView } from "../api/wire";
import type { PlainId } from "../messages/text";
import { t } from "./language";

const STAMPS: Record<NonNullable<TrialView["stamps"]>, PlainId> = {
  arrival: "ui-stamps-arrival",
  device: "ui-stamps-device",
  pulse: "ui-stamps-pulse",
};

/** Where time stamps come from. */
export function stampsText(stamps: TrialView["stamps"]): string {
  return stamps ? t(STAMPS[stamps]) : "–";
}
