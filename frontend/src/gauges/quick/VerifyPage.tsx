import { startVerification } from "../../api/guideCommands";
import type { VerificationFile, VerificationSummary, VerifyView } from "../../api/wire";
import { MainAct } from "../../controls/Actions";
import { Download } from "../../controls/Download";
import { EmptyState } from "../../controls/EmptyState";
import { newFindings } from "../../controls/findings";
import { moment } from "../../controls/format";
import { PressButton } from "../../controls/PressButton";
import { Reports } from "../../controls/Reports";
import { SessionCard } from "../../flow/SessionCard";
import { Layout } from "../../frame/Layout";
import { t } from "../../state/language";
import { asSent } from "../../state/localized";
import { go } from "../../state/router";
import { setState, useLive } from "../../state/store";
import { useList } from "../../state/useList";
import { useProbe } from "../../state/useProbe";
import { useRead } from "../../state/useRead";
import { BigVerdict, Verdict } from "../judgement/BigVerdict";
import { GaugeDrawing } from "../plan/GaugeDrawing";
import { StartCard } from "../session/StartCard";
import { CloudsView } from "./CloudsView";
import { GaugeChoice } from "./GaugeChoice";
import { RecordList } from "./RecordList";
import { ResultTabs } from "./ResultTabs";
import { TouchView } from "./TouchView";
import { displayedOf, displayedRecord } from "./verification";

/** The calibration in use, tried on a gauge: the guided flow, and what was found before. */
export function VerifyPage() {
  const view = useLive((s) => s.verify);
  const opened = useLive((s) => s.record);
  if (view?.running && !opened) return <Layout picture={<Picture view={view} />} card={<VerifyCard view={view} />} />;
  return <Records opened={opened} running={view?.running ?? false} />;
}

function Picture({ view }: { view: VerifyView }) {
  const { picture } = view;
  if (view.step === "gauge") return <GaugeChoice gauges={view.gauges} gauge={view.gauge} />;
  if (view.step === "touch") return <TouchView picture={picture} />;
  if (view.step === "scan") return <CloudsView picture={picture} busy={view.busy !== null} />;
  return <ResultTabs displayed={displayedOf(picture)} sent={displayedOf(asSent(picture))} />;
}

/** What to do in this step of a verification; in its result the verdict stands for the number. */
function VerifyCard({ view }: { view: VerifyView }) {
  const { verdict } = view.picture;
  return (
    <SessionCard
      guide="verify"
      view={view}
      number={verdict ? <Verdict {...verdict} /> : undefined}
      findings={newFindings(view.findings, view.actions, verdict ? [asSent(verdict).text] : [])}
    />
  );
}

function Records({ opened, running }: { opened: string | null; running: boolean }) {
  const grown = useLive((s) => s.verify?.session_id ?? "");
  const { list } = useList<VerificationSummary>("/api/verifications", `${grown} ${running}`);
  const summary = list?.find(({ id }) => id === opened) ?? list?.[0];
  const { value: file, failed } = useRead<VerificationFile>(summary ? `/api/verifications/${summary.id}` : "");
  const active = useLive((s) => s.home?.calibration ?? null);
  if (list && !summary) return <First calibrated={active !== null} />;
  const current = summary && summary.id === list?.[0]?.id && summary.calibration_id === active?.id;
  return (
    <Layout
      picture={<RecordView record={file} failed={failed} />}
      card={
        <>
          {summary && <BigVerdict summary={summary} />}
          {running ? (
            <MainAct>
              <PressButton free kind="primary" onPress={() => setState({ record: null })}>
                {t("ui-continue-verification")}
              </PressButton>
            </MainAct>
          ) : current && summary?.result !== "fail" ? (
            <MainAct>
              <PressButton free kind="primary" onPress={() => go("scan")}>
                {t("ui-scan-the-part")}
              </PressButton>
            </MainAct>
          ) : null}
          {!running && (
            <PressButton kind={current && summary?.result !== "fail" ? "secondary" : "primary"} onPress={begin}>
              {summary ? t("ui-verify-again") : t("ui-start-verification")}
            </PressButton>
          )}
          {summary && <Reports of={`/api/verifications/${summary.id}`} />}
          {summary && (
            <Download href={`/api/verifications/${summary.id}`}>
              {t("ui-record-of", { when: moment(summary.accepted_at) })}
            </Download>
          )}
          {list && list.length > 1 && <RecordList list={list} selected={summary?.id ?? ""} />}
        </>
      }
    />
  );
}

async function begin(): Promise<void> {
  setState({ record: null });
  await startVerification();
}

function First({ calibrated }: { calibrated: boolean }) {
  const touches = useProbe();
  return (
    <Layout
      picture={
        <EmptyState
          picture={<GaugeDrawing shape="sphere" touching={touches} scanning />}
          title={t("ui-calibration-good-check-gauge")}
          text={touches ? t("ui-touch-gauge-plate-sphere-probe-then") : t("ui-scan-gauge-plate-sphere")}
        />
      }
      card={
        <StartCard
          title={t("ui-verify-the-calibration")}
          text={t("ui-clamp-gauge-within-arms-reach")}
          calibrated={calibrated}
          start={t("ui-start-verification")}
          onStart={begin}
        />
      }
    />
  );
}

/** An earlier verification. */
function RecordView({ record, failed }: { record: VerificationFile | null; failed: boolean }) {
  if (failed)
    return <EmptyState title={t("ui-this-record-cannot-be-loaded")} text={t("ui-file-missing-data-folder-changed")} />;
  return (
    record && (
      <ResultTabs
        key={record.id}
        displayed={displayedRecord(record)}
        sent={displayedRecord(asSent(record))}
        id={record.id}
      />
    )
  );
}
