import type { ScanState } from "../api/scanTypes";
import { QualityMark } from "../parts/QualityMark";
import { duration, figures } from "../parts/format";
import { measured } from "../parts/lengths";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./ScanFigures.module.css";

/** How fast, how long, and what was lost. */
export function ScanFigures({ scan }: { scan: ScanState }) {
  const live = useLive((s) => s.connection === "live");
  return (
    <dl className={styles.figures} data-stale={!live || undefined}>
      <Figure label={t("Rate")} value={t("{n} points/s", { n: figures(scan.rate_points_s) })} />
      <Figure label={t("Time")} value={duration(scan.seconds)} />
      <Figure
        label={t("Blur")}
        value={scan.blur_mm === null ? "–" : measured(scan.blur_mm, "mm", 2)}
        lost={tooFast(scan)}
      />
      <Figure label={t("Spacing of lines")} value={scan.step_mm === null ? "–" : measured(scan.step_mm, "mm", 2)} />
      <Figure label={t("Pictures")} value={figures(scan.frames)} />
      <Figure label={t("Lost pictures")} value={figures(scan.lost_frames)} lost={scan.lost_frames > 0} />
      <Figure
        label={t("Without arm position")}
        value={figures(scan.frames_without_joints)}
        lost={scan.frames_without_joints > 0}
      />
    </dl>
  );
}

function tooFast({ blur_mm, blur_limit_mm }: ScanState): boolean {
  return blur_mm !== null && blur_limit_mm !== null && blur_mm > blur_limit_mm;
}

function Figure({ label, value, lost = false }: { label: string; value: string; lost?: boolean }) {
  return (
    <div className={styles.figure}>
      <dt>{label}</dt>
      <dd>
        {lost && <QualityMark quality="attention" size="1.125rem" />} {value}
      </dd>
    </div>
  );
}
