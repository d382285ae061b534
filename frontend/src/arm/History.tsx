import type { ArmCheckSummary, TipCheckSummary } from "../api/armTypes";
import { EmptyState } from "../parts/EmptyState";
import rows from "../parts/List.module.css";
import { Reports } from "../parts/Reports";
import { bound, moment } from "../parts/format";
import { lengthFigures, measured, unitOf } from "../parts/lengths";
import { QualityMark } from "../parts/QualityMark";
import { counted, t } from "../state/language";
import { useLive } from "../state/store";
import { useList } from "../state/useList";
import { GaugeDrawing } from "../verify/GaugeDrawing";
import styles from "./History.module.css";
import { HistoryChart } from "./HistoryChart";
import { SeatIllustration } from "./SeatIllustration";

/** Every finished check: of the arm as a line over time and one by one, of the tip one by one. */
export function History({ tips = false }: { tips?: boolean }) {
  return tips ? <TipHistory /> : <ArmHistory />;
}

function TipHistory() {
  const grown = useLive((s) => `${s.arm?.session_id ?? ""} ${s.arm?.step ?? ""}`);
  const { list } = useList<TipCheckSummary>("/api/arm/tips", grown);
  if (!list) return null;
  if (list.length === 0) {
    return (
      <EmptyState
        picture={<GaugeDrawing shape="sphere" touching />}
        title={t("No check of the tip yet")}
        text={t("A sphere of known diameter, touched in nine places with the wrist turned, tells a worn, bent or wrong tip before it spoils a day's work.")}
      />
    );
  }
  return (
    <div className={styles.history}>
      <h2 className={styles.title}>{t("Checks of the tip")}</h2>
      <ul className={rows.list}>
        {list.map((check) => (
          <TipRow key={check.id} check={check} />
        ))}
      </ul>
    </div>
  );
}

function TipRow({ check }: { check: TipCheckSummary }) {
  return (
    <li className={styles.row}>
      <QualityMark quality={check.verdict} />
      <div className={styles.what}>
        <p className={styles.when}>{moment(check.at)}</p>
        <p className={styles.detail}>{bound(check.text)}</p>
      </div>
      <dl className={styles.axes}>
        <dt>{t("Diameter")}</dt>
        <dd>{measured(check.diameter_mm, "mm", 3)}</dd>
      </dl>
      <Reports of={`/api/arm/tips/${check.id}`} />
    </li>
  );
}

function ArmHistory() {
  const grown = useLive((s) => `${s.arm?.session_id ?? ""} ${s.arm?.step ?? ""}`);
  const { list, failed } = useList<ArmCheckSummary>("/api/arm/checks", grown);
  if (!list) return failed ? <p className={styles.told}>{t("The checks could not be read. They are read again when the station is back.")}</p> : null;
  if (list.length === 0) {
    return (
      <EmptyState
        picture={<SeatIllustration />}
        title={t("No check yet")}
        text={t("Every check of the arm will stand here, as a line over time: (max − min)/2 of the tip on the worst axis, against your limit.")}
      />
    );
  }
  return (
    <div className={styles.history}>
      <h2 className={styles.title}>{t("Checks of the arm: (max − min)/2 on the worst axis")}</h2>
      <HistoryChart checks={list} />
      <ul className={rows.list}>
        {list.map((check) => (
          <Row key={check.id} check={check} />
        ))}
      </ul>
    </div>
  );
}

function Row({ check }: { check: ArmCheckSummary }) {
  const limit = check.limit_um === null ? t("no limit was set") : t("limit {value}", { value: measured(check.limit_um, "µm") });
  return (
    <li className={styles.row}>
      <QualityMark quality={check.verdict} />
      <div className={styles.what}>
        <p className={styles.when}>{moment(check.at)}</p>
        <p className={styles.detail}>
          {t("arm {serial}", { serial: check.arm_serial || check.arm_name })} · {counted(check.points, "{n} point", "{n} points")} · {limit}
        </p>
      </div>
      <Axes label="(max − min)/2" values={check.half_range_um} />
      <Axes label="2σ" values={check.two_sigma_um} />
      <Reports of={`/api/arm/checks/${check.id}`} />
    </li>
  );
}

function Axes({ label, values }: { label: string; values: number[] }) {
  return (
    <dl className={styles.axes}>
      <dt>{label} x, y, z</dt>
      <dd>{values.map((value) => lengthFigures(value, "µm")).join(" · ")} {unitOf("µm")}</dd>
    </dl>
  );
}
