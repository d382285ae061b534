import type { StationReport, StationShown } from "../api/watchTypes";
import { bound, figures, moment } from "../parts/format";
import { QualityMark } from "../parts/QualityMark";
import { t } from "../state/language";
import styles from "./StationCards.module.css";
import { doing, type Fact, facts, KINDS, stationState } from "./words";

/** Several stations side by side, the ones that need somebody first. */
export function StationCards({ stations, wall }: { stations: StationShown[]; wall: boolean }) {
  const ordered = [...stations].sort((a, b) => rank(a) - rank(b));
  return (
    <ul className={styles.cards} data-wall={wall || undefined} data-few={stations.length <= 4 || undefined} aria-label={t("Stations")}>
      {ordered.map((station) => (
        <Card key={station.id} station={station} wall={wall} />
      ))}
    </ul>
  );
}

function rank(station: StationShown): number {
  return { bad: 0, attention: 1, good: 2, neutral: 3 }[stationState(station).quality];
}

function Card({ station, wall }: { station: StationShown; wall: boolean }) {
  const { words, quality } = stationState(station);
  const { report } = station;
  return (
    <li className={styles.card} data-state={station.state} data-quality={quality}>
      <div className={styles.head}>
        <QualityMark quality={quality} size="1.4em" />
        <div>
          <h2 className={styles.name}>{station.name}</h2>
          <p className={styles.state}>{words}</p>
        </div>
        {report?.address && !wall && (
          <a className={styles.open} href={report.address} rel="noreferrer">
            {t("Open")}
          </a>
        )}
      </div>
      {report ? <Inside report={report} station={station} /> : <p className={styles.none}>{t("Nothing is known of it yet.")}</p>}
    </li>
  );
}

/** The disk is told of where it is nearly full. */
function isShown(fact: Fact): boolean {
  return fact.id !== "disk" || fact.quality !== "neutral";
}

function Inside({ report, station }: { report: StationReport; station: StationShown }) {
  const live = station.state === "live";
  const { title, number, unit, note } = doing(report);
  const alarm = report.alarms[0];
  const event = station.events[0];
  return (
    <>
      <div className={styles.doing}>
        <p className={styles.kind}>{live ? t(KINDS[report.activity.kind]) : t("As of {when}", { when: moment(report.at) })}</p>
        <p className={styles.what}>
          {number || title} {unit && <span>{unit}</span>}
        </p>
        <p className={styles.note}>{note}</p>
      </div>
      {live && alarm && (
        <p className={styles.alarm} data-quality={alarm.quality}>
          {report.alarms.length > 1
            ? t("{alarm}, and {n} more", { alarm: bound(alarm.text.replace(/\.$/, "")), n: figures(report.alarms.length - 1) })
            : bound(alarm.text)}
        </p>
      )}
      <dl className={styles.facts}>
        {facts(report, 0).filter(isShown).map((fact) => (
          <div key={fact.id} data-quality={live ? fact.quality : "neutral"}>
            <dt>{fact.label}</dt>
            <dd>
              {live && (fact.quality === "bad" || fact.quality === "attention") && (
                <QualityMark quality={fact.quality} size="0.9em" />
              )}
              {fact.value}
            </dd>
          </div>
        ))}
      </dl>
      {event && (
        <p className={styles.event}>
          {moment(event.at).slice(11)} {event.text}
        </p>
      )}
    </>
  );
}
