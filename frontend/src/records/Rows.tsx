import type { CalibrationSummary, VerificationSummary } from "../api/wire";
import { daysAgo, moment } from "../controls/format";
import rows from "../controls/List.module.css";
import { measured } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import { Reports } from "../controls/Reports";
import { POINT_DECIMALS } from "../controls/uncertainty";
import { DECISIONS, QUALITY } from "../gauges/quick/verification";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { go } from "../state/router";
import { setState } from "../state/store";
import styles from "./Rows.module.css";

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
