import type { ScanStatus } from "../api/wire";
import { duration, figures } from "../controls/format";
import { measured } from "../controls/lengths";
import { QualityMark } from "../controls/QualityMark";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./ScanFigures.module.css";

/** Rate, duration and losses. */
export function ScanFigures({ scan }: { scan: ScanStatus }) {
  const live = useLive((s) => s.connection === "live");
  return (
    <dl className={styles.figures} data-stale={!live || undefined}>
      <Figure label={t("ui-rate")} value={t("ui-points-s-n", { n: scan.rate_points_s })} />
      <Figure label={t("ui-time")} value={duration(scan.seconds)} />
      <Figure
        label={t("ui-blur")}
        value={scan.blur_mm === null ? "–" : measured(scan.blur_mm, "mm", 2)}
        lost={tooFast(scan)}
      />
      <Figure label={t("ui-line-spacing")} value={scan.step_mm === null ? "–" : measured(scan.step_mm, "mm", 2)} />
      <Figure label={t("ui-pictures")} value={figures(scan.frames)} />
      <Figure label={t("ui-lost-pictures")} value={figures(scan.lost_frames)} lost={scan.lost_frames > 0} />
      <Figure
        label={t("ui-without-arm-position")}
        value={figures(scan.frames_without_joints)}
        lost={scan.frames_without_joints > 0}
        bad={scan.incomplete}
      />
    </dl>
  );
}

function tooFast({ blur_mm, blur_limit_mm }: ScanStatus): boolean {
  return blur_mm !== null && blur_limit_mm !== null && blur_mm > blur_limit_mm;
}

interface FigureProps {
  label: string;
  value: string;
  lost?: boolean;
  /** So much that the scan is incomplete. */
  bad?: boolean;
}

function Figure({ label, value, lost = false, bad = false }: FigureProps) {
  return (
    <div className={styles.figure}>
      <dt>{label}</dt>
      <dd>
        {lost && <QualityMark quality={bad ? "bad" : "attention"} size="1.125rem" />} {value}
      </dd>
    </div>
  );
}
