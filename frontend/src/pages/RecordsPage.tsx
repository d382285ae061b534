import type { ReactNode } from "react";

import type {
  ArmCheckSummary,
  CalibrationSummary,
  IdentificationSummary,
  PerformanceSummary,
  ScanSummary,
  TipCheckSummary,
  VerificationSummary,
} from "../api/wire";
import { ArmRow, IdentifiedRow, TipRow } from "../arm/CheckRows";
import { useArmList } from "../arm/useArmList";
import { Banners } from "../frame/Banners";
import rows from "../parts/List.module.css";
import { PerformanceRow } from "../performance/PerformanceRow";
import { CalibrationHistory } from "../records/CalibrationHistory";
import { CalibrationRecord } from "../records/CalibrationRecord";
import { PerformanceHistory } from "../records/PerformanceHistory";
import { CalibrationRow, ScanRow, VerificationRow } from "../records/Rows";
import { t } from "../state/language";
import { useDetail } from "../state/router";
import { useLive } from "../state/store";
import { useList } from "../state/useList";
import styles from "./RecordsPage.module.css";

const CALIBRATION = "calibration/";

export function RecordsPage() {
  const detail = useDetail();
  return detail.startsWith(CALIBRATION) ? <CalibrationRecord id={detail.slice(CALIBRATION.length)} /> : <AllRecords />;
}

function AllRecords() {
  const calibrations = useList<CalibrationSummary>("/api/calibrations");
  const verified = useLive((s) => `${s.verify?.session_id ?? ""} ${s.verify?.running ?? ""}`);
  const verifications = useList<VerificationSummary>("/api/verifications", verified);
  const tested = useLive((s) => `${s.performance?.session_id ?? ""} ${s.performance?.running ?? ""}`);
  const performances = useList<PerformanceSummary>("/api/performances", tested);
  const checks = useChecks();
  const records = useLive((s) => s.view?.records ?? 0);
  const scans = useList<ScanSummary>("/api/scans", `${records}`);
  return (
    <main className={styles.page}>
      <div className={styles.records} tabIndex={0}>
        <h1 className="visually-hidden">{t("ui-records")}</h1>
        <Section
          title={t("ui-calibrations")}
          empty={t("ui-accepted-calibrations-appear-newest-first-accept")}
          above={<CalibrationHistory />}
          {...calibrations}
          row={(summary) => <CalibrationRow key={summary.id} summary={summary} />}
        />
        <Section
          title={t("ui-verifications")}
          empty={t("ui-accepted-verifications-appear-newest-first-make")}
          {...verifications}
          row={(summary) => <VerificationRow key={summary.id} summary={summary} />}
        />
        <Section
          title={t("ui-performance-tests")}
          empty={t("ui-performance-tests-appear-here")}
          above={<PerformanceHistory change={tested} />}
          {...performances}
          row={(summary) => <PerformanceRow key={summary.id} summary={summary} />}
        />
        <Section
          title={t("ui-arm-and-tip")}
          empty={t("ui-arm-checks-tip-checks-identifications-appear")}
          {...checks}
          row={({ row }) => row}
        />
        <Section
          title={t("ui-scans")}
          empty={t("ui-saved-clouds-appear-newest-first-start")}
          {...scans}
          row={(summary) => <ScanRow key={summary.id} summary={summary} />}
        />
      </div>
      <Banners />
    </main>
  );
}

interface Check {
  at: string;
  row: ReactNode;
}

/** Everything that was done to the arm and its tip, the newest first. */
function useChecks(): { list: Check[] | null; failed: boolean } {
  const arm = useArmList<ArmCheckSummary>("checks");
  const tip = useArmList<TipCheckSummary>("tips");
  const identified = useArmList<IdentificationSummary>("identifications");
  const failed = arm.failed || tip.failed || identified.failed;
  if (!arm.list || !tip.list || !identified.list) return { list: null, failed };
  const list: Check[] = [
    ...arm.list.map((check) => ({ at: check.at, row: <ArmRow key={check.id} check={check} /> })),
    ...tip.list.map((check) => ({ at: check.at, row: <TipRow key={check.id} check={check} /> })),
    ...identified.list.map((found) => ({ at: found.at, row: <IdentifiedRow key={found.id} found={found} /> })),
  ];
  return { list: list.sort((a, b) => b.at.localeCompare(a.at)), failed };
}

interface SectionProps<T> {
  title: string;
  above?: ReactNode;
  empty: string;
  list: T[] | null;
  failed: boolean;
  row: (item: T) => ReactNode;
}

function Section<T>({ title, above, empty, list, failed, row }: SectionProps<T>) {
  return (
    <section className={styles.section} aria-label={title}>
      <h2 className={`${rows.heading} ${styles.title}`}>{title}</h2>
      {above}
      {list && list.length > 0 ? (
        <ul className={rows.list}>{list.map(row)}</ul>
      ) : (
        <p className={rows.empty}>
          {list ? empty : failed ? t("ui-list-could-not-loaded-reloads-when") : t("ui-loading-the-list")}
        </p>
      )}
    </section>
  );
}
