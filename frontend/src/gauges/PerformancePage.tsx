import { useState } from "react";

import { startPerformance } from "../api/guideCommands";
import type { PerformanceFile, PerformanceSummary, PerformanceView } from "../api/wire";
import { Chips } from "../controls/Chips";
import { EmptyState } from "../controls/EmptyState";
import { moment } from "../controls/format";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { Reports } from "../controls/Reports";
import { Layout } from "../frame/Layout";
import { t } from "../state/language";
import { go, useDetail } from "../state/router";
import { getState, useLive } from "../state/store";
import { useList } from "../state/useList";
import { useRead } from "../state/useRead";
import { ExportFiles } from "./exchange/ExportFiles";
import { Verdict } from "./judgement/BigVerdict";
import { PerformanceRow } from "./judgement/PerformanceRow";
import { ResultTable } from "./judgement/ResultTable";
import { KINDS, type KindName } from "./kinds";
import styles from "./PerformancePage.module.css";
import { ArtefactChoice } from "./plan/ArtefactChoice";
import { GaugeDrawing } from "./plan/GaugeDrawing";
import { Temperatures } from "./plan/Temperatures";
import { PerformanceCard } from "./session/PerformanceCard";
import { StartCard } from "./session/StartCard";

/** Arm and scanner against their datasheet: the guided test on a sphere, and the tests before. */
export function PerformancePage() {
  const view = useLive((s) => s.performance);
  const opened = useDetail();
  if (opened) return <Record id={opened} />;
  if (view?.running) return <Layout picture={<Picture view={view} />} card={<PerformanceCard view={view} />} />;
  return <Before />;
}

function Picture({ view }: { view: PerformanceView }) {
  const { picture, step } = view;
  const { Picture: Own, Result } = KINDS[view.test];
  if (step === "artefact") return <ArtefactChoice view={view} />;
  if (step === "review")
    return picture.result ? (
      <ResultTable result={picture.result}>{Result && <Result view={view} />}</ResultTable>
    ) : (
      <EmptyState title="" text="" />
    );
  if (step === "temperatures")
    return (
      <div className={styles.temperatures}>
        <Temperatures view={view} end />
      </div>
    );
  return <Own view={view} />;
}

function Before() {
  const ended = useLive((s) => `${s.performance?.session_id ?? ""} ${s.performance?.running ?? ""}`);
  const { list } = useList<PerformanceSummary>("/api/performances", ended);
  const calibrated = useLive((s) => (s.home?.calibration ?? null) !== null);
  // the one that was done last is offered first
  const [test, setTest] = useState<KindName>(() => getState().performance?.test ?? "sphere");
  const { title, about, needs, scans, drawing, Before: Prepared } = KINDS[test];
  return (
    <Layout
      picture={
        list && list.length > 0 ? (
          <div className={styles.list}>
            <h2 className={styles.heading}>{t("ui-performance-tests")}</h2>
            <ul className={rows.list}>
              {list.map((summary) => (
                <PerformanceRow key={summary.id} summary={summary} />
              ))}
            </ul>
          </div>
        ) : (
          <EmptyState
            picture={drawing && <GaugeDrawing {...drawing} />}
            title={t("ui-performance-first-title")}
            text={t(about)}
          />
        )
      }
      card={
        <StartCard
          title={t(title)}
          text={t(needs)}
          calibrated={calibrated || !scans}
          start={t("ui-start-the-test")}
          onStart={() => startPerformance(test)}
        >
          <Chips
            label={t("ui-kind-of-test")}
            options={(Object.keys(KINDS) as KindName[]).map((value) => ({ value, label: t(KINDS[value].label) }))}
            value={test}
            onChange={setTest}
          />
          {Prepared && <Prepared />}
        </StartCard>
      }
    />
  );
}

function Record({ id }: { id: string }) {
  const { value: file, failed } = useRead<PerformanceFile>(`/api/performances/${id}`);
  const Own = file && KINDS[file.kind].Record;
  return (
    <Layout
      picture={
        failed ? (
          <EmptyState title={t("ui-this-record-cannot-be-loaded")} text={t("ui-file-missing-data-folder-changed")} />
        ) : (
          file && <ResultTable result={displayed(file)}>{Own && <Own file={file} />}</ResultTable>
        )
      }
      card={
        <>
          {file && (
            <Verdict {...file.verdict}>
              <p>
                {namesOf(file)} · {moment(file.ended_at)}
              </p>
            </Verdict>
          )}
          <PressButton free onPress={() => go("performance")}>
            {t("ui-performance-tests")}
          </PressButton>
          <Reports of={`/api/performances/${id}`} />
          <ExportFiles id={id} />
        </>
      }
    />
  );
}

/** Of the artefacts that a test was done on. */
function namesOf({ sphere, length, plate }: PerformanceFile) {
  return [sphere, length, plate].flatMap((artefact) => (artefact ? [artefact.name] : [])).join(", ");
}

function displayed(file: PerformanceFile) {
  return {
    status: file.status ?? "",
    problems: file.problems ?? [],
    notes: file.notes ?? [],
    offset: file.offset?.text ?? "",
    figures: file.figures.map((figure) => ({
      ...figure,
      value: figure.value ?? null,
      values: figure.values ?? [],
      limit: figure.limit ?? null,
      test_uncertainty: figure.test_uncertainty ?? null,
      problem: figure.problem ?? "",
    })),
  };
}
