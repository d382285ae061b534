import type { ArmCheckSummary } from "../api/wire";
import { TimeChart } from "../controls/TimeChart";
import { t } from "../state/language";

const MOST_POINTS = 40;

/** The last checks from left to right. */
export function HistoryChart({ checks }: { checks: ArmCheckSummary[] }) {
  const points = checks
    .slice(0, MOST_POINTS)
    .reverse()
    .map((check) => ({
      id: check.id,
      at: check.at,
      value: Math.max(...check.half_range_um),
      limit: check.limit_um,
      quality: check.verdict,
    }));
  return <TimeChart points={points} unit="µm" label={t("ui-checks-over-time")} />;
}
