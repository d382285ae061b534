import { useState } from "react";

import { compareRecord, endComparison } from "../api/recordCommands";
import type { OpenedRecord, RecordComparison, ScanSummary } from "../api/wire";
import look from "../controls/Control.module.css";
import { moment } from "../controls/format";
import { measured, signedLength } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import section from "../controls/Section.module.css";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { useList } from "../state/useList";
import styles from "./ScanRecord.module.css";

interface ComparisonProps {
  scan: ScanSummary;
  opened: OpenedRecord;
}

/** How far the opened record lies from another one, coloured in the view. */
export function Comparison({ scan, opened }: ComparisonProps) {
  const { list } = useList<ScanSummary>("/api/scans");
  const others = (list ?? []).filter((one) => one.id !== scan.id && !one.away && one.points > 0);
  const [chosen, setChosen] = useState("");
  const reference = others.find(({ id }) => id === chosen) ?? others[0];
  if (!reference) return null;
  return (
    <section className={section.section} aria-label={t("ui-comparison")}>
      <h2 className={section.heading}>{t("ui-comparison")}</h2>
      {opened.comparison ? (
        <Deviation found={opened.comparison} />
      ) : (
        <div className={styles.choice}>
          <select
            className={look.input}
            aria-label={t("ui-compare-with")}
            value={reference.id}
            onChange={(event) => setChosen(event.target.value)}
          >
            {others.map((one) => (
              <option key={one.id} value={one.id}>
                {[one.part.part, one.part.serial_number, one.name, moment(one.started_at)].filter(Boolean).join(" · ")}
              </option>
            ))}
          </select>
          <PressButton
            disabled={opened.busy !== ""}
            why={opened.busy}
            onPress={async () => void (await compareRecord(scan.id, reference.id))}
          >
            {t("ui-compare")}
          </PressButton>
        </div>
      )}
    </section>
  );
}

function Deviation({ found: { reference, deviation, same_calibration } }: { found: RecordComparison }) {
  const rows = [
    [t("ui-mean-deviation"), signedLength(deviation.mean_um, "µm", 1)],
    [t("ui-rms"), measured(deviation.rms_um, "µm", 1)],
    [t("ui-95-percent-within"), measured(deviation.p95_um, "µm", 1)],
    [t("ui-compared-points"), t("ui-n-points", { n: deviation.points })],
    [
      t("ui-planes-of-comparison"),
      t("ui-planes-flat-to", {
        radius: measured(deviation.plane_mm, "mm", 1),
        flatness: measured(deviation.flatness_um, "µm", 1),
      }),
    ],
    [t("ui-not-on-the-other"), measured(100 * deviation.share_beside, "%", 1)],
  ];
  return (
    <>
      <p>{t("ui-deviation-from", { name: isolated(reference) })}</p>
      <dl className={styles.facts}>
        {rows.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      <p className={styles.honest}>
        {t("ui-comparison-is-scatter-and-change")} {same_calibration ? "" : t("ui-comparison-of-two-calibrations")}
      </p>
      <PressButton onPress={async () => void (await endComparison())}>{t("ui-end-comparison")}</PressButton>
    </>
  );
}
