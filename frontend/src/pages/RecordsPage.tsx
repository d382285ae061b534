import { type ReactNode, useDeferredValue, useState } from "react";

import type {
  ArmCheckSummary,
  CalibrationSummary,
  IdentificationSummary,
  InspectionSummary,
  PerformanceSummary,
  TipCheckSummary,
  VerificationSummary,
} from "../api/wire";
import { ArmRow, IdentifiedRow, TipRow } from "../arm/CheckRows";
import { useArmList } from "../arm/useArmList";
import { Chips } from "../controls/Chips";
import { moment } from "../controls/format";
import rows from "../controls/List.module.css";
import { TextField } from "../controls/TextField";
import { Banners } from "../frame/Banners";
import { PerformanceHistory } from "../gauges/judgement/PerformanceHistory";
import { PerformanceRow } from "../gauges/judgement/PerformanceRow";
import type { PlainId } from "../messages/text";
import { InspectionRow } from "../parts/InspectionRow";
import { CalibrationHistory } from "../records/CalibrationHistory";
import { CalibrationRecord } from "../records/CalibrationRecord";
import { OpenedNote } from "../records/OpenedNote";
import { CalibrationRow, VerificationRow } from "../records/Rows";
import { ScanList } from "../records/ScanList";
import { ScanRecord } from "../records/ScanRecord";
import { matches } from "../records/search";
import { t } from "../state/language";
import { useDetail } from "../state/router";
import { useLive } from "../state/store";
import { useList } from "../state/useList";
import styles from "./RecordsPage.module.css";

const CALIBRATION = "calibration/";
const SCAN = "scan/";
const KINDS = ["all", "scans", "calibrations", "verifications", "performance", "inspections", "arm"] as const;
type Kind = (typeof KINDS)[number];
const KIND_WORDS: Record<Kind, PlainId> = {
  all: "ui-all",
  scans: "ui-scans",
  calibrations: "ui-calibrations",
  verifications: "ui-verifications",
  performance: "ui-performance-tests",
  inspections: "ui-part-inspections",
  arm: "ui-arm-and-tip",
};

export function RecordsPage() {
  const detail = useDetail();
  if (detail.startsWith(CALIBRATION)) return <CalibrationRecord id={detail.slice(CALIBRATION.length)} />;
  if (detail.startsWith(SCAN)) return <ScanRecord id={detail.slice(SCAN.length)} />;
  return <AllRecords />;
}

function AllRecords() {
  const [kind, setKind] = useState<Kind>("all");
  const [typed, setTyped] = useState("");
  const search = useDeferredValue(typed);
  const calibrations = useList<CalibrationSummary>("/api/calibrations");
  const verified = useLive((s) => `${s.verify?.session_id ?? ""} ${s.verify?.running ?? ""}`);
  const verifications = useList<VerificationSummary>("/api/verifications", verified);
  const tested = useLive((s) => `${s.performance?.session_id ?? ""} ${s.performance?.running ?? ""}`);
  const performances = useList<PerformanceSummary>("/api/performances", tested);
  const inspected = useLive((s) => `${s.parts?.session_id ?? ""} ${s.parts?.running ?? ""}`);
  const inspections = useList<InspectionSummary>("/api/parts/inspections", inspected);
  const checks = useChecks();
  const shows = (one: Kind) => kind === "all" || kind === one;
  const history = search === "";
  return (
    <main className={styles.page}>
      <div className={styles.records} tabIndex={0}>
        <h1 className="visually-hidden">{t("ui-records")}</h1>
        <div className={styles.filter}>
          <TextField label={t("ui-search-records")} type="search" value={typed} onText={setTyped} />
          <Chips
            label={t("ui-kind")}
            value={kind}
            onChange={setKind}
            options={KINDS.map((value) => ({ value, label: t(KIND_WORDS[value]) }))}
          />
        </div>
        <OpenedNote />
        {shows("scans") && <ScanList search={search} />}
        {shows("calibrations") && (
          <Section
            title={t("ui-calibrations")}
            empty={t("ui-accepted-calibrations-appear-newest-first-accept")}
            above={history && <CalibrationHistory />}
            {...found(calibrations, search, ({ name, accepted_at, arm_serial, sensor_serial, object_serial }) => [
              ...[name, moment(accepted_at), arm_serial, sensor_serial, object_serial],
            ])}
            row={(summary) => <CalibrationRow key={summary.id} summary={summary} />}
          />
        )}
        {shows("verifications") && (
          <Section
            title={t("ui-verifications")}
            empty={t("ui-accepted-verifications-appear-newest-first-make")}
            {...found(verifications, search, ({ gauge, accepted_at, calibration, operator }) => [
              ...[gauge, moment(accepted_at), calibration, operator],
            ])}
            row={(summary) => <VerificationRow key={summary.id} summary={summary} />}
          />
        )}
        {shows("performance") && (
          <Section
            title={t("ui-performance-tests")}
            empty={t("ui-performance-tests-appear-here")}
            above={history && <PerformanceHistory change={tested} />}
            {...found(performances, search, ({ artefact, ended_at, operator, text }) => [
              ...[artefact, moment(ended_at), operator, text],
            ])}
            row={(summary) => <PerformanceRow key={summary.id} summary={summary} />}
          />
        )}
        {shows("inspections") && (
          <Section
            title={t("ui-part-inspections")}
            empty={t("ui-part-inspections-appear-here")}
            {...found(inspections, search, ({ part, program, serial_number, ended_at, operator, text }) => [
              ...[part, program, serial_number, moment(ended_at), operator, text],
            ])}
            row={(summary) => <InspectionRow key={summary.id} summary={summary} />}
          />
        )}
        {shows("arm") && (
          <Section
            title={t("ui-arm-and-tip")}
            empty={t("ui-arm-checks-tip-checks-identifications-appear")}
            {...found(checks, search, ({ at }) => [moment(at)])}
            row={({ row }) => row}
          />
        )}
      </div>
      <Banners />
    </main>
  );
}

interface Listed<T> {
  list: T[] | null;
  failed: boolean;
}

/** Those of a list that a search finds. */
function found<T>({ list, failed }: Listed<T>, search: string, texts: (one: T) => string[]): SectionList<T> {
  const some = list?.filter((one) => matches(search, texts(one))) ?? null;
  return { list: some, failed, hidden: (list?.length ?? 0) > 0 && some?.length === 0 };
}

interface Check {
  at: string;
  row: ReactNode;
}

/** Everything that was done to the arm and its tip, the newest first. */
function useChecks(): Listed<Check> {
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

interface SectionList<T> extends Listed<T> {
  /** The search finds none of them. */
  hidden: boolean;
}

interface SectionProps<T> extends SectionList<T> {
  title: string;
  above?: ReactNode;
  empty: string;
  row: (item: T) => ReactNode;
}

function Section<T>({ title, above, empty, list, failed, hidden, row }: SectionProps<T>) {
  if (hidden) return null;
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
