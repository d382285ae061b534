import { type DragEvent, type ReactNode, useState } from "react";

import { cancelComparison, sendPart } from "../api/partCommands";
import type { ComparisonFile, PlaceOnMap, ScanSummary } from "../api/wire";
import look from "../controls/Control.module.css";
import fields from "../controls/Field.module.css";
import { moment } from "../controls/format";
import { PressButton } from "../controls/PressButton";
import { Busy } from "../controls/Progress";
import { QualityMark } from "../controls/QualityMark";
import { useBarred } from "../state/control";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { useList } from "../state/useList";
import { useRead } from "../state/useRead";
import { CompareForm } from "./CompareForm";
import styles from "./ComparePanel.module.css";
import { MapResult } from "./MapResult";

interface ComparePanelProps {
  /** The tapped place of the map. */
  place: PlaceOnMap | null;
  onClosePlace: () => void;
}

/** A finished scan against its part: the file is dropped here, and the map appears in the view. */
export function ComparePanel({ place, onClosePlace }: ComparePanelProps) {
  const compare = useLive((s) => s.compare);
  const records = useLive((s) => s.view?.records ?? 0);
  const displayed = useLive((s) => s.view?.scans);
  const running = useLive((s) => (s.scan?.state === "running" || s.scan?.state === "stopping" ? s.scan.scan_id : null));
  const last = useLive((s) => s.compare?.shown?.result.scan ?? s.library?.opened?.id ?? s.scan?.scan_id ?? null);
  const { list } = useList<ScanSummary>("/api/scans", `${records} ${displayed?.length}`);
  const [chosen, setChosen] = useState<string | null>(null);
  const scans = (list ?? []).filter(({ id }) => id !== running && displayed?.some((one) => one.id === id));
  const scan = scans.find(({ id }) => id === chosen) ?? scans.find(({ id }) => id === last) ?? scans[0];
  if (!compare) return null;
  return (
    <PartDrop>
      <h2 className={styles.title}>{t("ui-compare-with-a-part")}</h2>
      {!scan && <p className={styles.note}>{running ? t("ui-finish-the-scan-first") : t("ui-no-scan-to-compare")}</p>}
      {scan && scans.length > 1 && (
        <select
          className={`${look.input} ${fields.input} ${styles.scan}`}
          aria-label={t("ui-scan")}
          value={scan.id}
          onChange={(event) => setChosen(event.target.value)}
        >
          {scans.map((one) => (
            <option key={one.id} value={one.id}>
              {`${isolated(one.name)} · ${moment(one.started_at)}`}
            </option>
          ))}
        </select>
      )}
      {scan && <ScanPart key={scan.id} scan={scan} place={place} onClosePlace={onClosePlace} />}
    </PartDrop>
  );
}

/** A place on which the file of a part is dropped. */
function PartDrop({ children }: { children: ReactNode }) {
  const [over, setOver] = useState(false);
  const barred = useBarred() !== "";
  const reading = useLive((s) => s.compare?.reading ?? null);
  const drag = (event: DragEvent) => {
    if (barred || reading || !event.dataTransfer.types.includes("Files")) return;
    event.preventDefault();
    setOver(true);
  };
  const drop = (event: DragEvent) => {
    const file = event.dataTransfer.files[0];
    setOver(false);
    if (!file) return;
    event.preventDefault();
    if (!barred && !reading) void sendPart(file);
  };
  return (
    <div
      className={styles.panel}
      data-over={over || undefined}
      onDragOver={drag}
      onDragLeave={() => setOver(false)}
      onDrop={drop}
    >
      {children}
    </div>
  );
}

/** What is under way, what was found, or what to compare the scan with. */
function ScanPart({ scan, place, onClosePlace }: ComparePanelProps & { scan: ScanSummary }) {
  const compare = useLive((s) => s.compare);
  const [again, setAgain] = useState(false);
  const path = `/api/scans/${encodeURIComponent(scan.id)}/deviation`;
  const { value: result } = useRead<ComparisonFile>(path, `${compare?.made}`);
  const current = compare?.shown?.result.scan === scan.id ? compare.shown.result : result;
  const kept = current && current.scan === scan.id ? current : null;
  const [made, setMade] = useState(compare?.made);
  if (made !== compare?.made) {
    setMade(compare?.made);
    setAgain(false);
  }
  if (!compare) return null;
  if (compare.running) {
    const { text, share, is_cancelled } = compare.running;
    return (
      <>
        <Busy text={is_cancelled ? t("ui-cancelling") : text} fraction={share} />
        <PressButton disabled={is_cancelled} onPress={async () => void (await cancelComparison())}>
          {t("ui-cancel")}
        </PressButton>
      </>
    );
  }
  return (
    <>
      {compare.refused && (
        <p className={styles.refused} role="alert">
          <QualityMark quality="bad" size="1.25rem" />
          <span>
            <strong>{isolated(compare.refused.name)}</strong> {compare.refused.text}
          </span>
        </p>
      )}
      {kept && !again && !compare.reading ? (
        <MapResult result={kept} place={place} onClosePlace={onClosePlace} onAgain={() => setAgain(true)} />
      ) : (
        <CompareForm scan={scan.id} parts={compare.parts} reading={compare.reading}>
          {kept && (
            <PressButton free kind="quiet" onPress={() => setAgain(false)}>
              {t("ui-back-to-the-map")}
            </PressButton>
          )}
        </CompareForm>
      )}
    </>
  );
}
