import { fetchScan } from "../api/viewCommands";
import type { CalibrationSummary, ScanSummary, VerificationSummary } from "../api/wire";
import { Download } from "../parts/Download";
import { daysAgo, duration, moment } from "../parts/format";
import rows from "../parts/List.module.css";
import { measured } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { QualityMark } from "../parts/QualityMark";
import { Reports } from "../parts/Reports";
import { POINT_DECIMALS } from "../parts/uncertainty";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { go } from "../state/router";
import { setState } from "../state/store";
import { DECISIONS, QUALITY } from "../verify/verification";
import styles from "./Rows.module.css";
import { ScanActs } from "./ScanActs";

export function CalibrationRow({ summary }: { summary: CalibrationSummary }) {
  return (
    <li className={`${rows.row} ${styles.row}`} data-active={summary.active || undefined}>
      <QualityMark quality={summary.verdict} />
      <div className={styles.what}>
        <p className={rows.name}>
          {isolated(summary.name)}
          {summary.active && <span className={rows.badge}>{t("ui-active")}</span>}
        </p>
        <p className={rows.detail}>
          {moment(summary.accepted_at)}, {daysAgo(summary.age_days)} ·{" "}
          {t("ui-arm-serial", { serial: summary.arm_serial })} ·{" "}
          {t("ui-sensor-serial", { serial: summary.sensor_serial })} ·{" "}
          {t("ui-object-serial", { serial: summary.object_serial })}
        </p>
      </div>
      <p className={styles.value}>
        {measured(summary.total_um, "µm", POINT_DECIMALS)} <span>k = 1</span>
      </p>
      <PressButton free onPress={() => go("records", `calibration/${summary.id}`)}>
        {t("ui-open")}
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
    <li className={`${rows.row} ${styles.row}`}>
      <QualityMark quality={QUALITY[summary.result]} />
      <div className={styles.what}>
        <p className={rows.name}>
          {t(DECISIONS[summary.result])}: {isolated(summary.gauge)}
        </p>
        <p className={rows.detail}>
          {moment(summary.accepted_at)} · {t("ui-n-clouds", { n: summary.clouds })} ·{" "}
          {t("ui-of", { calibration: summary.calibration })}
          {summary.operator && ` · ${isolated(summary.operator)}`}
        </p>
      </div>
      <PressButton free onPress={open}>
        {t("ui-open")}
      </PressButton>
      <Reports of={`/api/verifications/${summary.id}`} />
    </li>
  );
}

export function ScanRow({ summary }: { summary: ScanSummary }) {
  return (
    <li className={`${rows.row} ${styles.row}`}>
      {summary.incomplete && <QualityMark quality="bad" />}
      <div className={styles.what}>
        <p className={rows.name}>{isolated(summary.name)}</p>
        <p className={rows.detail}>
          {moment(summary.started_at)} · {duration(summary.seconds)} · {t("ui-n-pictures", { n: summary.frames })}
        </p>
        {summary.note && (
          <p className={rows.detail} data-bad={summary.incomplete || undefined}>
            {summary.note}
          </p>
        )}
      </div>
      <p className={styles.value}>{t("ui-n-points", { n: summary.points })}</p>
      <ScanActs scan={summary} />
      {summary.away ? (
        <PressButton onPress={() => void fetchScan(summary.id)}>{t("ui-fetch")}</PressButton>
      ) : (
        <Download href={`/api/scans/${summary.id}/cloud.ply`}>PLY</Download>
      )}
    </li>
  );
}
