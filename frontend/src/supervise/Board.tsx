import { useRef, useState } from "react";

import { newKey } from "../api/commands";
import type { Alarm, StationReport } from "../api/wire";
import { QualityMark } from "../controls/QualityMark";
import { CloudView } from "../scan/CloudView";
import { t } from "../state/language";
import styles from "./Board.module.css";
import { doing, type Fact, facts, KINDS } from "./stationFacts";

/** One station for a kiosk screen: current activity, problems, and the live cloud. */
export function Board({ report, silent_s }: { report: StationReport; silent_s: number }) {
  return (
    <div className={styles.board} data-stale={silent_s > 0 || undefined}>
      <Doing report={report} />
      <Alarms alarms={report.alarms} />
      <Cloud />
      <dl className={styles.facts}>
        {facts(report, silent_s).map((fact) => (
          <FactTile key={fact.id} fact={fact} />
        ))}
      </dl>
    </div>
  );
}

function Doing({ report }: { report: StationReport }) {
  const { title, number, unit, note } = doing(report);
  return (
    <section
      className={styles.doing}
      aria-label={t("ui-current-activity")}
      data-idle={report.activity.kind === "idle" || undefined}
    >
      <p className={styles.kind}>{t(KINDS[report.activity.kind])}</p>
      <h2 className={styles.what}>
        {number ? number : title}
        {unit && <span> {unit}</span>}
      </h2>
      <p className={styles.note}>{note}</p>
    </section>
  );
}

function Alarms({ alarms }: { alarms: Alarm[] }) {
  return (
    <section className={styles.alarms} aria-label={t("ui-alarms")} tabIndex={0}>
      {alarms.length === 0 && (
        <p className={styles.alarm} data-quality="good">
          <QualityMark quality="good" size="1.25em" />
          <span>{t("ui-no-alarms")}</span>
        </p>
      )}
      {alarms.map((alarm) => (
        <div key={alarm.text} className={styles.alarm} data-quality={alarm.quality}>
          <QualityMark quality={alarm.quality} size="1.25em" />
          <div>
            <p>{alarm.text}</p>
            {alarm.remedy && <p className={styles.remedy}>{alarm.remedy}</p>}
          </div>
        </div>
      ))}
    </section>
  );
}

function Cloud() {
  const frame = useRef<HTMLIFrameElement>(null);
  const [viewKey] = useState(newKey);
  return (
    <section className={styles.cloud} aria-label={t("ui-live-cloud")}>
      <CloudView viewKey={viewKey} frame={frame} />
    </section>
  );
}

function FactTile({ fact }: { fact: Fact }) {
  return (
    <div className={styles.fact} data-quality={fact.quality}>
      <dt>{fact.label}</dt>
      <dd className={styles.value}>
        {fact.quality !== "neutral" && <QualityMark quality={fact.quality} size="0.85em" />}
        <span>{fact.value}</span>
      </dd>
      <dd className={styles.under}>{fact.note}</dd>
    </div>
  );
}
