import { startPerformance } from "../api/guideCommands";
import type { PerformanceFile, PerformanceSummary, PerformanceView } from "../api/wire";
import { Layout } from "../frame/Layout";
import { EmptyState } from "../parts/EmptyState";
import { moment } from "../parts/format";
import rows from "../parts/List.module.css";
import { PressButton } from "../parts/PressButton";
import { Reports } from "../parts/Reports";
import { ArtefactChoice } from "../performance/ArtefactChoice";
import { ArticulationList } from "../performance/ArticulationList";
import { CertificateUpload } from "../performance/CertificateUpload";
import { ExportFiles } from "../performance/ExportFiles";
import { PerformanceCard } from "../performance/PerformanceCard";
import { PerformanceRow } from "../performance/PerformanceRow";
import { ResultTable } from "../performance/ResultTable";
import { SphereMap } from "../performance/SphereMap";
import { t } from "../state/language";
import { go, useDetail } from "../state/router";
import { useLive } from "../state/store";
import { useList } from "../state/useList";
import { Verdict } from "../verify/BigVerdict";
import { GaugeDrawing } from "../verify/GaugeDrawing";
import { StartCard } from "../verify/StartCard";
import { useFile } from "../verify/useFile";
import styles from "./PerformancePage.module.css";

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
  if (step === "artefact") return <ArtefactChoice view={view} />;
  if (step === "review")
    return picture.result ? (
      <ResultTable result={picture.result} aside={picture.aside} />
    ) : (
      <EmptyState title="" text="" />
    );
  return (
    <div className={styles.step}>
      <SphereMap picture={picture} />
      {picture.articulations.length > 0 && (
        <ArticulationList lines={picture.articulations} repeatable={step === "scan" && view.busy === null} />
      )}
    </div>
  );
}

function Before() {
  const ended = useLive((s) => `${s.performance?.session_id ?? ""} ${s.performance?.running ?? ""}`);
  const { list } = useList<PerformanceSummary>("/api/performances", ended);
  const calibrated = useLive((s) => (s.home?.calibration ?? null) !== null);
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
            picture={<GaugeDrawing shape="sphere" touching scanning />}
            title={t("ui-performance-first-title")}
            text={t("ui-performance-first-text")}
          />
        )
      }
      card={
        <StartCard
          title={t("ui-test-the-performance")}
          text={t("ui-performance-needs")}
          calibrated={calibrated}
          start={t("ui-start-the-test")}
          onStart={startPerformance}
        >
          <CertificateUpload />
        </StartCard>
      }
    />
  );
}

function Record({ id }: { id: string }) {
  const { file, failed } = useFile<PerformanceFile>(`/api/performances/${id}`);
  return (
    <Layout
      picture={
        failed ? (
          <EmptyState title={t("ui-this-record-cannot-be-loaded")} text={t("ui-file-missing-data-folder-changed")} />
        ) : (
          file && <ResultTable result={displayed(file)} />
        )
      }
      card={
        <>
          {file && (
            <Verdict {...file.verdict}>
              <p>
                {file.sphere?.name} · {moment(file.ended_at)}
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
