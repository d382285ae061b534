import type { ScanSummary } from "../api/scanTypes";
import type { ShownScan } from "../api/viewTypes";
import { showScan } from "../api/viewCommands";
import { figures, moment } from "../parts/format";
import { ScanActs } from "../records/ScanActs";
import { useBarred } from "../state/control";
import { isolated } from "../state/isolated";
import { counted, t } from "../state/language";
import { useLive } from "../state/store";
import { useList } from "../state/useList";
import styles from "./ScansPanel.module.css";

/** Which scans are in the picture; several may be. */
export function ScansPanel() {
  const records = useLive((s) => s.view?.records ?? 0);
  const shown = useLive((s) => s.view?.scans);
  const running = useLive((s) => (s.scan?.state === "running" || s.scan?.state === "stopping" ? s.scan.scan_id : null));
  const { list, failed } = useList<ScanSummary>("/api/scans", `${records}`);
  if (!list) return <p>{failed ? t("The list could not be read.") : t("Reading the list.")}</p>;
  return (
    <>
      <h2 className={styles.title}>{t("Scans in the picture")}</h2>
      {running && <p className={styles.running}>{t("The scan that is being recorded is always shown.")}</p>}
      {list.length === 0 && !running && <p className={styles.empty}>{t("Finished scans will be here. Press Start scan for the first.")}</p>}
      <ul className={styles.list}>
        {list.map((scan) => (
          <ScanLine key={scan.id} scan={scan} shown={shown?.find(({ id }) => id === scan.id)} />
        ))}
      </ul>
    </>
  );
}

function ScanLine({ scan, shown }: { scan: ScanSummary; shown: ShownScan | undefined }) {
  const barred = useBarred() !== "";
  return (
    <li className={styles.line}>
      <button
        type="button"
        role="switch"
        aria-checked={shown !== undefined}
        className={styles.switch}
        aria-disabled={barred || undefined}
        onClick={() => !barred && void showScan(scan.id, !shown)}
      >
        <span className={styles.box} aria-hidden="true" />
        <span className={styles.words}>
          <span className={styles.name}>{isolated(scan.name)}</span>
          <span className={styles.detail}>{detailOf(scan, shown)}</span>
        </span>
      </button>
      <ScanActs scan={scan} />
    </li>
  );
}

function detailOf(scan: ScanSummary, shown: ShownScan | undefined): string {
  if (shown && shown.loaded < 1) return t("Reading, {n} %", { n: figures(100 * shown.loaded) });
  return `${moment(scan.started_at)} · ${counted(scan.points, "{n} point", "{n} points")}`;
}
