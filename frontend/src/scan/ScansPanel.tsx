import { showScan } from "../api/viewCommands";
import type { ScanSummary, VisibleScan } from "../api/wire";
import { moment } from "../controls/format";
import { quantity } from "../messages/text";
import { ScanActs } from "../records/ScanActs";
import { useBarred } from "../state/control";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { useList } from "../state/useList";
import styles from "./ScansPanel.module.css";

/** The scans in the view; there may be several. */
export function ScansPanel() {
  const records = useLive((s) => s.view?.records ?? 0);
  const displayed = useLive((s) => s.view?.scans);
  const running = useLive((s) => (s.scan?.state === "running" || s.scan?.state === "stopping" ? s.scan.scan_id : null));
  const { list, failed } = useList<ScanSummary>("/api/scans", `${records}`);
  if (!list) return <p>{failed ? t("ui-the-list-could-not-be-loaded-sentence") : t("ui-loading-the-list")}</p>;
  return (
    <>
      <h2 className={styles.title}>{t("ui-displayed-scans")}</h2>
      {running && <p className={styles.running}>{t("ui-the-current-scan-is-always-displayed")}</p>}
      {list.length === 0 && !running && (
        <p className={styles.empty}>{t("ui-finished-scans-appear-press-start-scan")}</p>
      )}
      <ul className={styles.list}>
        {list.map((scan) => (
          <ScanLine key={scan.id} scan={scan} displayed={displayed?.find(({ id }) => id === scan.id)} />
        ))}
      </ul>
    </>
  );
}

function ScanLine({ scan, displayed }: { scan: ScanSummary; displayed: VisibleScan | undefined }) {
  const barred = useBarred() !== "";
  return (
    <li className={styles.line}>
      <button
        type="button"
        role="switch"
        aria-checked={displayed !== undefined}
        className={styles.switch}
        aria-disabled={barred || undefined}
        onClick={() => !barred && void showScan(scan.id, !displayed)}
      >
        <span className={styles.box} aria-hidden="true" />
        <span className={styles.words}>
          <span className={styles.name}>{isolated(scan.name)}</span>
          <span className={styles.detail}>{detailOf(scan, displayed)}</span>
          {scan.incomplete && <span className={styles.incomplete}>{scan.note}</span>}
        </span>
      </button>
      <ScanActs scan={scan} />
    </li>
  );
}

function detailOf(scan: ScanSummary, displayed: VisibleScan | undefined): string {
  if (displayed && displayed.loaded < 1) return t("ui-loading-share", { share: quantity(100 * displayed.loaded, "%") });
  return `${moment(scan.started_at)} · ${t("ui-n-points", { n: scan.points })}`;
}
