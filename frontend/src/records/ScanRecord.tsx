import { useState } from "react";

import { continueRecord, namePart, openRecord } from "../api/recordCommands";
import type { ScanSummary } from "../api/wire";
import { BigNumber } from "../controls/BigNumber";
import { CardHead } from "../controls/CardHead";
import { duration, moment } from "../controls/format";
import { PressButton } from "../controls/PressButton";
import { Reports } from "../controls/Reports";
import section from "../controls/Section.module.css";
import { Layout } from "../frame/Layout";
import { SaveCloud } from "../scan/SaveCloud";
import { ScanPicture } from "../scan/ScanPicture";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { go } from "../state/router";
import { useLive } from "../state/store";
import { useRead } from "../state/useRead";
import { Comparison } from "./Comparison";
import { OpenedNote } from "./OpenedNote";
import { PartForm } from "./PartForm";
import { ReplayBar } from "./ReplayBar";
import { ScanActs } from "./ScanActs";
import styles from "./ScanRecord.module.css";
import { findingsOf, pictureOf } from "./ScanRow";

/** One scan of the records: in the 3D view if it is opened, with all that can be done with it. */
export function ScanRecord({ id }: { id: string }) {
  const records = useLive((s) => s.view?.records ?? 0);
  const { value: scan, failed } = useRead<ScanSummary>(`/api/scans/${encodeURIComponent(id)}`, `${records}`);
  const opened = useLive((s) => (s.library?.opened?.id === id ? s.library.opened : null));
  if (!scan) {
    const text = failed ? t("ui-there-is-no-such-record") : t("ui-loading-the-record");
    return <Layout picture={null} card={<Head title={t("ui-scan")} text={text} />} />;
  }
  return (
    <Layout
      picture={opened ? <ScanPicture /> : <LargePicture key={id} scan={scan} />}
      card={
        <>
          <Head title={isolated(scan.name)} text={opened ? t("ui-shown-in-the-3d-view") : t("ui-open-to-turn-it")} />
          {opened ? <OpenedNote /> : <OpenButton scan={scan} />}
          {opened && scan.seconds > 0 && <ReplayBar record={opened} />}
          <BigNumber
            number={{
              label: t("ui-points"),
              value: scan.points,
              unit: "",
              decimals: 0,
              quality: scan.incomplete ? "bad" : "neutral",
              note: scan.note || findingsOf(scan),
            }}
          />
          <Facts scan={scan} />
          <Acts scan={scan} />
          {opened && <Comparison scan={scan} opened={opened} />}
          <Files scan={scan} />
        </>
      }
    />
  );
}

/** The small picture, which the list has shown already, until the large one is drawn. */
function LargePicture({ scan }: { scan: ScanSummary }) {
  const [drawn, setDrawn] = useState(false);
  const before = drawn ? undefined : { backgroundImage: `url("${pictureOf(scan)}")` };
  return (
    <img className={styles.large} style={before} src={pictureOf(scan, true)} alt="" onLoad={() => setDrawn(true)} />
  );
}

function Head({ title, text }: { title: string; text: string }) {
  return (
    <>
      <div>
        <PressButton free kind="quiet" onPress={() => go("records")}>
          ← {t("ui-all-records")}
        </PressButton>
      </div>
      <CardHead title={title} text={text} />
    </>
  );
}

function OpenButton({ scan }: { scan: ScanSummary }) {
  const running = useLive((s) => s.scan?.state === "running" || s.scan?.state === "stopping");
  const why = scan.away ? t("ui-fetch-it-from-the-archive-first") : running ? t("ui-a-scan-is-running") : "";
  return (
    <PressButton
      kind="primary"
      disabled={why !== ""}
      why={why}
      onPress={async () => void (await openRecord(scan.id, true))}
    >
      {t("ui-open-in-the-3d-view")}
    </PressButton>
  );
}

function Facts({ scan }: { scan: ScanSummary }) {
  const { part, serial_number, order, customer } = scan.part;
  const unnamed = t("ui-not-stated");
  const rows = [
    [t("ui-part"), isolated(part) || unnamed],
    [t("ui-serial-number"), isolated(serial_number) || unnamed],
    [t("ui-order"), isolated(order) || unnamed],
    [t("ui-customer"), isolated(customer) || unnamed],
    [t("ui-calibration"), isolated(scan.calibration) || unnamed],
    [t("ui-begun"), moment(scan.started_at)],
    [t("ui-duration"), duration(scan.seconds)],
    [t("ui-pictures"), t("ui-n-pictures", { n: scan.frames })],
    ...scan.sources.map((source, i) => [i ? "" : t("ui-merged-of"), isolated(source)] as const),
  ] as const;
  return (
    <dl className={styles.facts}>
      {rows.map(([name, value], i) => (
        <div key={i}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}

function Acts({ scan }: { scan: ScanSummary }) {
  const [naming, setNaming] = useState(false);
  const continued = useLive((s) => s.library?.continued?.id === scan.id);
  const next = async () => {
    if (await continueRecord(scan.id, true)) go("scan");
  };
  return (
    <div className={styles.acts}>
      <PressButton onPress={() => setNaming(true)}>{t("ui-name-part")}</PressButton>
      {!scan.away && !continued && <PressButton onPress={next}>{t("ui-continue-this-scan")}</PressButton>}
      <ScanActs scan={scan} onDeleted={() => go("records")} />
      {naming && (
        <PartForm
          title={t("ui-part-of-this-scan")}
          part={scan.part}
          onSave={(part) => namePart(scan.id, part)}
          onClose={() => setNaming(false)}
        />
      )}
    </div>
  );
}

function Files({ scan }: { scan: ScanSummary }) {
  if (scan.away) return null;
  return (
    <section className={section.section} aria-label={t("ui-files-of-record")}>
      <h2 className={section.heading}>{t("ui-files-of-record")}</h2>
      <Reports of={`/api/scans/${scan.id}`} />
      <SaveCloud id={scan.id} />
    </section>
  );
}
