import { setScanHand, startScan, stopScan } from "../api/commands";
import type { ScanState } from "../api/scanTypes";
import type { Action } from "../api/types";
import { Layout } from "../frame/Layout";
import { Actions } from "../parts/Actions";
import { BigNumber } from "../parts/BigNumber";
import { CardHead } from "../parts/CardHead";
import { Download } from "../parts/Download";
import { Findings } from "../parts/Findings";
import { NextStep } from "../home/NextStep";
import { t, words } from "../state/language";
import { useLive } from "../state/store";
import { ReplayCard } from "../scan/ReplayCard";
import { ScanFigures } from "../scan/ScanFigures";
import { ScanPicture } from "../scan/ScanPicture";

const WORDS: Record<ScanState["state"], { title: string; text: string }> = {
  idle: { title: words("Ready to scan"), text: words("Start, then pass the stripe slowly over the part.") },
  running: { title: words("Scanning"), text: words("Pass the stripe slowly over the part.") },
  stopping: { title: words("Stopping"), text: words("The cloud is being written.") },
  blocked: { title: words("Scanning is not possible now"), text: words("The reason stands by the button.") },
};

export function ScanPage() {
  const scan = useLive((s) => s.scan);
  const hasHand = useLive((s) => s.station?.has_hand ?? false);
  const replay = useLive((s) => s.replay);
  if (replay) return <Layout picture={<ScanPicture />} card={<ReplayCard replay={replay} />} />;
  if (!scan) return <Layout picture={<ScanPicture />} card={<CardHead title={t("Scan")} text={t("Waiting for the station.")} />} />;
  const { title, text } = WORDS[scan.state];
  return (
    <Layout
      picture={<ScanPicture />}
      card={
        <>
          <CardHead title={t(title)} text={t(text)} help="scan" />
          <BigNumber
            number={{ label: t("Points"), value: scan.points, unit: "", decimals: 0, quality: "neutral", note: shown(scan) }}
          />
          <ScanFigures scan={scan} />
          <Actions actions={actionsOf(scan, hasHand)} onAct={act}>
            {scan.state === "idle" && scan.scan_id && scan.points > 0 && (
              <Download href={`/api/scans/${scan.scan_id}/cloud.ply`}>{t("Save as PLY")}</Download>
            )}
            <Findings findings={scan.findings} />
            {scan.state === "blocked" && <NextStep />}
          </Actions>
        </>
      }
    />
  );
}

function shown(scan: ScanState): string {
  return scan.points_shown < scan.points ? t("the view shows a part of them") : "";
}

function action(name: string, label: string, primary: boolean, why_not = ""): Action {
  return { name, label, args: {}, primary, enabled: why_not === "", why_not, confirm: "" };
}

function actionsOf(scan: ScanState, hasHand: boolean): Action[] {
  const running = scan.state === "running";
  const main = running
    ? action("stop", t("Stop the scan"), true)
    : action("start", t("Start scan"), true, scan.state === "stopping" ? t("The last scan is being written.") : scan.why_not);
  if (!hasHand || scan.state === "blocked") return [main];
  const hand = scan.hand_running
    ? action("hand_off", t("Stop the hand"), false)
    : action("hand_on", t("Let the hand do it"), false);
  return [main, hand];
}

async function act({ name }: Action): Promise<void> {
  if (name === "start") return startScan();
  if (name === "stop") return stopScan();
  return setScanHand(name === "hand_on");
}
