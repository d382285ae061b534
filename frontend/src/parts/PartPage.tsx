import { startInspection } from "../api/guideCommands";
import type { DimensionLine, InspectionSummary, PartRecordView, PartView } from "../api/wire";
import { MainAct } from "../controls/Actions";
import { CardHead } from "../controls/CardHead";
import { Download } from "../controls/Download";
import { EmptyState } from "../controls/EmptyState";
import { moment } from "../controls/format";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { Layout } from "../frame/Layout";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { go, useDetail } from "../state/router";
import { useLive } from "../state/store";
import { useList } from "../state/useList";
import { useRead } from "../state/useRead";
import { DimensionTable } from "./DimensionTable";
import { FeatureChips } from "./FeatureChips";
import { InspectionRow } from "./InspectionRow";
import { PartCard, VerdictLine } from "./PartCard";
import { PartDrawing } from "./PartDrawing";
import styles from "./PartPage.module.css";
import { SetupForm } from "./SetupForm";
import { TouchList } from "./TouchList";

/** Is the part as its drawing wants it: the guided inspection, and those before. */
export function PartPage() {
  const view = useLive((s) => s.parts);
  const opened = useDetail();
  if (opened) return <Record id={opened} />;
  if (view?.running) return <Layout picture={<Picture view={view} />} card={<PartCard view={view} />} />;
  return <Before />;
}

function Picture({ view }: { view: PartView }) {
  if (view.step === "setup") return <SetupForm view={view} />;
  if (view.step === "review") {
    if (!view.result) return <EmptyState title="" text="" />;
    return <Result lines={view.result.dimensions} warnings={view.result.warnings} id={view.session_id} />;
  }
  return (
    <div className={styles.step}>
      <PartDrawing view={view} />
      <TouchList view={view} />
      <FeatureChips view={view} />
    </div>
  );
}

interface ResultProps {
  lines: readonly DimensionLine[];
  warnings: readonly string[];
  /** Of the inspection, for its files. */
  id: string;
}

function Result({ lines, warnings, id }: ResultProps) {
  return (
    <div className={styles.result}>
      <DimensionTable lines={lines} />
      {warnings.map((text) => (
        <p key={text} className={styles.warning}>
          {text}
        </p>
      ))}
      <Files id={id} />
    </div>
  );
}

function Files({ id }: { id: string }) {
  return (
    <div className={styles.files}>
      <Download href={`/api/parts/inspections/${id}`}>results.json</Download>
      <Download href={`/api/parts/inspections/${id}/folder.zip`}>{t("ui-part-whole-folder")}</Download>
    </div>
  );
}

function Before() {
  const ended = useLive((s) => `${s.parts?.session_id ?? ""} ${s.parts?.running ?? ""}`);
  const { list } = useList<InspectionSummary>("/api/parts/inspections", ended);
  const calibrated = useLive((s) => (s.home?.calibration ?? null) !== null);
  return (
    <Layout
      picture={
        list && list.length > 0 ? (
          <div className={styles.list}>
            <h2 className={styles.heading}>{t("ui-part-inspections")}</h2>
            <ul className={rows.list}>
              {list.map((summary) => (
                <InspectionRow key={summary.id} summary={summary} />
              ))}
            </ul>
          </div>
        ) : (
          <EmptyState title={t("ui-part-first-title")} text={t("ui-part-first-text")} />
        )
      }
      card={
        <>
          <CardHead
            title={t("ui-part-title")}
            text={calibrated ? t("ui-part-needs") : t("ui-part-without-calibration")}
          />
          <MainAct>
            {calibrated ? (
              <PressButton kind="primary" onPress={startInspection}>
                {t("ui-part-start")}
              </PressButton>
            ) : (
              <PressButton free kind="primary" onPress={() => go("calibrate")}>
                {t("ui-calibrate")}
              </PressButton>
            )}
          </MainAct>
        </>
      }
    />
  );
}

function Record({ id }: { id: string }) {
  const { value: record, failed } = useRead<PartRecordView>(`/api/parts/inspections/${id}/view`);
  return (
    <Layout
      picture={
        failed ? (
          <EmptyState title={t("ui-this-record-cannot-be-loaded")} text={t("ui-file-missing-data-folder-changed")} />
        ) : (
          record && <Result lines={record.result.dimensions} warnings={record.result.warnings} id={id} />
        )
      }
      card={
        <>
          {record && (
            <>
              <CardHead title={isolated(record.part)} text={whenAndWho(record)} />
              <VerdictLine result={record.result} />
              {record.frame && <p className={styles.frame}>{record.frame}</p>}
            </>
          )}
          <PressButton free onPress={() => go("part")}>
            {t("ui-part-inspections")}
          </PressButton>
        </>
      }
    />
  );
}

function whenAndWho({ ended_at, operator }: PartRecordView): string {
  return [moment(ended_at), operator && isolated(operator)].filter(Boolean).join(" · ");
}
