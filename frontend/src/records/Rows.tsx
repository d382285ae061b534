import type { CalibrationSummary } from "../api/homeTypes";
import type { ScanSummary } from "../api/scanTypes";
import { Download } from "../parts/Download";
import { daysAgo, duration, moment } from "../parts/format";
import { measured } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { QualityMark } from "../parts/QualityMark";
import { Reports } from "../parts/Reports";
import type { VerificationSummary } from "../api/verifyTypes";
import { isolated } from "../state/isolated";
import { counted, said, t } from "../state/language";
import { go } from "../state/router";
import { setState } from "../state/store";
import { QUALITY, WORD } from "../verify/shown";
import { ScanActs } from "./ScanActs";
import styles from "./Rows.module.css";

export function CalibrationRow({ summary }: { summary: CalibrationSummary }) {
  return (
    <li className={styles.row} data-active={summary.active || undefined}>
      <QualityMark quality={summary.verdict} />
      <div className={styles.what}>
        <p className={styles.name}>
          {said(summary.name)}
          {summary.active && <span className={styles.active}>{t("active")}</span>}
        </p>
        <p className={styles.detail}>
          {moment(summary.accepted_at)}, {daysAgo(summary.age_days)} · {t("arm {serial}", { serial: summary.arm_serial })} ·{" "}
          {t("sensor {serial}", { serial: summary.sensor_serial })} · {t("object {serial}", { serial: summary.object_serial })}
        </p>
      </div>
      <p className={styles.value}>
        {measured(summary.total_um, "µm")} <span>k = 1</span>
      </p>
      <PressButton free onPress={() => go("records", `calibration/${summary.id}`)}>
        {t("Look at it")}
      </PressButton>
      <Reports of={`/api/calibrations/${summary.id}`} />
    </li>
  );
}

export function VerificationRow({ summary }: { summary: VerificationSummary }) {
  const open = () => {
    setState({ record: summary.id });
    go("verify");
  };
  return (
    <li className={styles.row}>
      <QualityMark quality={QUALITY[summary.result]} />
      <div className={styles.what}>
        <p className={styles.name}>
          {t(WORD[summary.result])}: {said(summary.gauge)}
        </p>
        <p className={styles.detail}>
          {moment(summary.accepted_at)} · {counted(summary.clouds, "{n} cloud", "{n} clouds")} · {t("of {calibration}", { calibration: said(summary.calibration) })}
          {summary.operator && ` · ${isolated(summary.operator)}`}
        </p>
      </div>
      <PressButton free onPress={open}>
        {t("Open")}
      </PressButton>
      <Reports of={`/api/verifications/${summary.id}`} />
    </li>
  );
}

export function ScanRow({ summary }: { summary: ScanSummary }) {
  return (
    <li className={styles.row}>
      <div className={styles.what}>
        <p className={styles.name}>{isolated(summary.name)}</p>
        <p className={styles.detail}>
          {moment(summary.started_at)} · {duration(summary.seconds)} · {counted(summary.frames, "{n} picture", "{n} pictures")}
        </p>
        {summary.note && <p className={styles.detail}>{said(summary.note)}</p>}
      </div>
      <p className={styles.value}>{counted(summary.points, "{n} point", "{n} points")}</p>
      <ScanActs scan={summary} />
      <Download href={`/api/scans/${summary.id}/cloud.ply`}>PLY</Download>
    </li>
  );
}
