import { startVerify } from "../api/verifyCommands";
import type { VerificationRecord } from "../api/verifyFiles";
import type { VerificationSummary, VerifyView } from "../api/verifyTypes";
import { Layout } from "../frame/Layout";
import { MainAct } from "../parts/Actions";
import { t } from "../state/language";
import { BigVerdict } from "../verify/BigVerdict";
import { CardHead } from "../parts/CardHead";
import { Download } from "../parts/Download";
import { EmptyState } from "../parts/EmptyState";
import { moment } from "../parts/format";
import { PressButton } from "../parts/PressButton";
import { Reports } from "../parts/Reports";
import { go } from "../state/router";
import { asSent } from "../state/spoken";
import { setState, useLive } from "../state/store";
import { useList } from "../state/useList";
import { CloudsView } from "../verify/CloudsView";
import { GaugeChoice } from "../verify/GaugeChoice";
import { GaugeDrawing } from "../verify/GaugeDrawing";
import { RecordList } from "../verify/RecordList";
import { RecordView } from "../verify/RecordView";
import { ResultTabs } from "../verify/ResultTabs";
import { shownOf } from "../verify/shown";
import { TouchView } from "../verify/TouchView";
import { useFile } from "../verify/useFile";
import { VerifyCard } from "../verify/VerifyCard";

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
  return <ResultTabs shown={shownOf(picture)} sent={shownOf(asSent(picture))} />;
}

function Records({ opened, running }: { opened: string | null; running: boolean }) {
  const grown = useLive((s) => s.verify?.session_id ?? "");
  const { list } = useList<VerificationSummary>("/api/verifications", `${grown} ${running}`);
  const shown = list?.find(({ id }) => id === opened) ?? list?.[0];
  const { file, failed } = useFile<VerificationRecord>(shown ? `/api/verifications/${shown.id}` : "");
  const active = useLive((s) => s.home?.calibration ?? null);
  if (list && !shown) return <First calibrated={active !== null} />;
  const current = shown && shown.id === list?.[0]?.id && shown.calibration_id === active?.id;
  return (
    <Layout
      picture={<RecordView record={file} failed={failed} />}
      card={
        <>
          {shown && <BigVerdict summary={shown} />}
          {running ? (
            <MainAct>
              <PressButton free kind="primary" onPress={() => setState({ record: null })}>
                {t("Go on verifying")}
              </PressButton>
            </MainAct>
          ) : current && shown?.result !== "fail" ? (
            <MainAct>
              <PressButton free kind="primary" onPress={() => go("scan")}>
                {t("Scan the part")}
              </PressButton>
            </MainAct>
          ) : null}
          {!running && (
            <PressButton kind={current && shown?.result !== "fail" ? "secondary" : "primary"} onPress={begin}>
              {shown ? t("Verify again") : t("Start verification")}
            </PressButton>
          )}
          {shown && <Reports of={`/api/verifications/${shown.id}`} />}
          {shown && (
            <Download href={`/api/verifications/${shown.id}`}>{t("Record of {when}", { when: moment(shown.accepted_at) })}</Download>
          )}
          {list && list.length > 1 && <RecordList list={list} shown={shown?.id ?? ""} />}
        </>
      }
    />
  );
}

async function begin(): Promise<void> {
  setState({ record: null });
  await startVerify();
}

function First({ calibrated }: { calibrated: boolean }) {
  return (
    <Layout
      picture={
        <EmptyState
          picture={<GaugeDrawing shape="sphere" touching scanning />}
          title={t("Is the calibration good? A gauge tells")}
          text={t("You touch a gauge plate or sphere with the probe, then scan it a few times. The clouds are compared with the gauge's paper and with the probe, against your limits, with their uncertainty. It takes two minutes.")}
        />
      }
      card={
        <>
          <CardHead
            title={t("Verify the calibration")}
            text={calibrated ? t("Clamp a gauge within the arm's reach.") : t("There is no calibration in use yet. Calibrate first.")}
          />
          <MainAct>
            {calibrated ? (
              <PressButton kind="primary" onPress={begin}>
                {t("Start verification")}
              </PressButton>
            ) : (
              <PressButton free kind="primary" onPress={() => go("calibrate")}>
                {t("Calibrate")}
              </PressButton>
            )}
          </MainAct>
        </>
      }
    />
  );
}
