import { setSimulatedOperator, startScan, stopScan } from "../api/commands";
import type { Action, ScanStatus } from "../api/wire";
import { Actions } from "../controls/Actions";
import { BigNumber } from "../controls/BigNumber";
import { CardHead } from "../controls/CardHead";
import { Findings } from "../controls/Findings";
import { SensorSegments } from "../controls/SensorSegments";
import { Layout } from "../frame/Layout";
import { NextStep } from "../home/NextStep";
import type { PlainId } from "../messages/text";
import { ContinuedNote, OpenedNote } from "../records/OpenedNote";
import { NextPart } from "../records/PartForm";
import { ReplayCard } from "../scan/ReplayCard";
import { SaveCloud } from "../scan/SaveCloud";
import { ScanFigures } from "../scan/ScanFigures";
import { ScanPicture } from "../scan/ScanPicture";
import { t } from "../state/language";
import { useLive } from "../state/store";

const WORDS: Record<ScanStatus["state"], { title: PlainId; text: PlainId }> = {
  idle: { title: "ui-ready-to-scan", text: "ui-start-then-move-stripe-slowly-over" },
  running: { title: "ui-scanning", text: "ui-move-stripe-slowly-over-part" },
  stopping: { title: "ui-stopping", text: "ui-saving-the-cloud" },
  blocked: { title: "ui-scanning-is-not-possible-now", text: "ui-reason-next-button" },
};

export function ScanPage() {
  const scan = useLive((s) => s.scan);
  const hasOperator = useLive((s) => s.station?.has_simulation ?? false);
  const replay = useLive((s) => s.replay);
  if (replay) return <Layout picture={<ScanPicture />} card={<ReplayCard replay={replay} />} />;
  if (!scan)
    return (
      <Layout
        picture={<ScanPicture />}
        card={<CardHead title={t("ui-scan")} text={t("ui-waiting-for-the-station")} />}
      />
    );
  const ended = scan.state === "idle" && scan.scan_id !== null;
  const { title, text } = ended ? endedWords(scan) : WORDS[scan.state];
  return (
    <Layout
      picture={<ScanPicture />}
      card={
        <>
          <CardHead title={t(title)} text={t(text)} help="scan" />
          <OpenedNote />
          <ContinuedNote />
          <NextPart />
          {ended && <Findings findings={scan.findings} />}
          <SensorSegments />
          <BigNumber
            number={{
              label: t("ui-points"),
              value: scan.points,
              unit: "",
              decimals: 0,
              quality: scan.incomplete ? "bad" : "neutral",
              note: displayedShare(scan),
            }}
          />
          {!ended && <ScanFigures scan={scan} />}
          <Actions actions={actionsOf(scan, hasOperator)} onAct={act}>
            {scan.state === "idle" && scan.scan_id && scan.points > 0 && <SaveCloud id={scan.scan_id} />}
            {ended ? <ScanFigures scan={scan} /> : <Findings findings={scan.findings} />}
            {scan.state === "blocked" && <NextStep />}
          </Actions>
        </>
      }
    />
  );
}

/** What became of the last scan, with its findings right below. */
function endedWords({ points, incomplete }: ScanStatus): { title: PlainId; text: PlainId } {
  if (points === 0) return { title: "ui-the-scan-has-no-points", text: "ui-scan-part-again" };
  return { title: incomplete ? "ui-the-scan-is-incomplete" : "ui-the-scan-is-saved", text: "ui-it-is-under-records" };
}

function displayedShare(scan: ScanStatus): string {
  if (scan.incomplete) return t("ui-the-scan-is-incomplete");
  return scan.points_shown < scan.points ? t("ui-view-contains-only-some-them") : "";
}

function action(name: string, label: string, primary: boolean, why_not = ""): Action {
  return { name, label, args: {}, primary, enabled: why_not === "", why_not, confirm: "" };
}

function actionsOf(scan: ScanStatus, hasOperator: boolean): Action[] {
  const running = scan.state === "running";
  const main = running
    ? action("stop", t("ui-stop-the-scan"), true)
    : action(
        "start",
        t("ui-start-scan"),
        true,
        scan.state === "stopping" ? t("ui-saving-the-last-scan") : scan.why_not,
      );
  if (!hasOperator || scan.state === "blocked") return [main];
  const operator = scan.simulation_running
    ? action("operator_off", t("ui-stop-the-simulated-operator"), false)
    : action(
        "operator_on",
        running ? t("ui-let-the-simulated-operator-do-it") : t("ui-let-the-simulated-operator-scan"),
        false,
      );
  return [main, operator];
}

async function act({ name }: Action): Promise<void> {
  if (name === "start") return startScan();
  if (name === "stop") return stopScan();
  return setSimulatedOperator(name === "operator_on");
}
