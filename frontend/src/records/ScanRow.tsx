import { memo, useState } from "react";

import { openRecord } from "../api/recordCommands";
import { fetchScan } from "../api/viewCommands";
import type { PartNames, ScanSummary } from "../api/wire";
import { duration, moment } from "../controls/format";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import { addressOf } from "../state/base";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { go } from "../state/router";
import styles from "./ScanRow.module.css";

interface ScanRowProps {
  scan: ScanSummary;
  chosen: boolean;
  onChoose: (id: string, on: boolean) => void;
}

/** One scan of the list: what it shows, what it is of, and what it lacks. */
export const ScanRow = memo(function ScanRow({ scan, chosen, onChoose }: ScanRowProps) {
  const open = async () => {
    if (await openRecord(scan.id, true)) go("records", `scan/${scan.id}`);
  };
  return (
    <li className={styles.row}>
      <label className={styles.choose}>
        <input
          type="checkbox"
          checked={chosen}
          aria-label={t("ui-choose-record", { name: scan.name })}
          onChange={(event) => onChoose(scan.id, event.target.checked)}
        />
      </label>
      <CloudPicture scan={scan} />
      <div>
        <p className={rows.name}>
          {scan.incomplete && <QualityMark quality="bad" size="1.25rem" />}
          {/* the name of a scan is its time, unless somebody gave it another */}
          <a
            href={addressOf(`/records/scan/${scan.id}`)}
            onClick={(event) => {
              event.preventDefault();
              go("records", `scan/${scan.id}`);
            }}
          >
            {isolated(scan.name)}
          </a>
          {scan.sources.length > 0 && (
            <span className={rows.badge}>{t("ui-n-scans-merged", { n: scan.sources.length })}</span>
          )}
        </p>
        {partOf(scan.part) && <p>{partOf(scan.part)}</p>}
        <p className={rows.detail}>
          {moment(scan.started_at)} · {duration(scan.seconds)}
          {scan.calibration && ` · ${t("ui-of", { calibration: scan.calibration })}`}
        </p>
        {findingsOf(scan) && <p className={styles.findings}>{findingsOf(scan)}</p>}
        {scan.note && (
          <p className={rows.detail} data-bad={scan.incomplete || undefined}>
            {scan.note}
          </p>
        )}
      </div>
      <p className={styles.value}>{t("ui-n-points", { n: scan.points })}</p>
      {scan.away ? (
        <PressButton onPress={() => void fetchScan(scan.id)}>{t("ui-fetch")}</PressButton>
      ) : (
        <PressButton onPress={open}>{t("ui-open")}</PressButton>
      )}
    </li>
  );
});

function CloudPicture({ scan }: { scan: ScanSummary }) {
  const [missing, setMissing] = useState(false);
  return (
    <div className={styles.picture}>
      {missing ? (
        t("ui-no-picture")
      ) : (
        <img src={pictureOf(scan)} alt="" loading="lazy" decoding="async" onError={() => setMissing(true)} />
      )}
    </div>
  );
}

/** A cloud that has grown or was cut has another picture. */
export function pictureOf(scan: ScanSummary, large = false): string {
  return addressOf(`/api/scans/${encodeURIComponent(scan.id)}/picture.png?large=${large}&changed=${scan.changed_ns}`);
}

/** Part, serial number, order and customer, as far as they are stated. */
export function partOf({ part, serial_number, order, customer }: PartNames): string {
  return [
    isolated(part),
    serial_number && t("ui-serial-number-of", { number: serial_number }),
    order && t("ui-order-of", { order }),
    isolated(customer),
  ]
    .filter(Boolean)
    .join(" · ");
}

/** What is to be known of it, in a line; empty if nothing is. */
export function findingsOf(scan: ScanSummary): string {
  return [
    scan.frames_too_fast && t("ui-n-of-all-too-fast", { n: scan.frames_too_fast, all: scan.frames }),
    scan.frames_lost && t("ui-n-pictures-lost", { n: scan.frames_lost }),
    !scan.incomplete &&
      scan.frames_without_points > 0 &&
      t("ui-n-pictures-without-points", { n: scan.frames_without_points }),
  ]
    .filter(Boolean)
    .join(" · ");
}

/** What a search looks through. */
export function textsOf(scan: ScanSummary): string[] {
  const { part, serial_number, order, customer } = scan.part;
  return [
    ...[scan.name, scan.id, part, serial_number, order, customer],
    ...[scan.calibration, moment(scan.started_at), ...scan.sources],
  ];
}
