import { useDeferredValue, useEffect, useState } from "react";

import type { RemoteStation, StationReport } from "../api/wire";
import { moment } from "../controls/format";
import { QualityMark } from "../controls/QualityMark";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import styles from "./StationCards.module.css";
import { doing, type Fact, facts, KINDS, sensorFacts, stationState } from "./stationFacts";

/** Number of cards at first, and added per press: anyone who may publish can invent stations. */
const CARDS = 48;

interface Cards {
  stations: RemoteStation[];
  /** performance.now() at the time of the reports. */
  at: number;
  kiosk: boolean;
}

/** Several stations side by side; those that need attention come first. */
export function StationCards(newest: Cards) {
  const { stations, at, kiosk } = useDeferredValue(newest, { ...newest, stations: [] });
  const [most, setMost] = useState(CARDS);
  return (
    <ul
      className={styles.cards}
      data-kiosk={kiosk || undefined}
      data-few={stations.length <= 4 || undefined}
      aria-label={t("ui-stations")}
    >
      <Ordered stations={stations.slice(0, most)} at={at} kiosk={kiosk} />
      {stations.length > most && (
        <li className={styles.more}>
          <button type="button" onClick={() => setMost(most + CARDS)}>
            {t("ui-display-more", { n: stations.length - most })}
          </button>
        </li>
      )}
    </ul>
  );
}

function Ordered({ stations, at, kiosk }: Cards) {
  return stations
    .sort((a, b) => rank(a) - rank(b))
    .map((station) => <Card key={station.id} station={station} at={at} kiosk={kiosk} />);
}

/** Seconds since a moment, updated while wanted. */
function useSince(at: number, on: boolean): number {
  const [now, setNow] = useState(at);
  useEffect(() => {
    if (!on) return;
    const timer = setInterval(() => setNow(performance.now()), 1000);
    return () => clearInterval(timer);
  }, [on]);
  return Math.max(now - at, 0) / 1000;
}

function rank(station: RemoteStation): number {
  return { bad: 0, attention: 1, good: 2, neutral: 3 }[stationState(station).quality];
}

function Card({ station, at, kiosk }: { station: RemoteStation; at: number; kiosk: boolean }) {
  const lost = station.state === "lost";
  const { words, quality } = stationState(station, useSince(at, lost));
  const { report } = station;
  return (
    <li className={styles.card} data-state={station.state} data-quality={quality}>
      <div className={styles.head}>
        <QualityMark quality={quality} size="1.4em" />
        <div>
          <h2 className={styles.name}>{isolated(station.name)}</h2>
          <p className={styles.state}>{words}</p>
        </div>
        {report?.address && !kiosk && (
          <a className={styles.open} href={report.address} rel="noreferrer">
            {t("ui-open")}
          </a>
        )}
      </div>
      {report ? <Inside report={report} station={station} /> : <p className={styles.none}>{t("ui-no-data-yet")}</p>}
    </li>
  );
}

/** The disk is shown only if it is nearly full. */
function isRelevant(fact: Fact): boolean {
  return fact.id !== "disk" || fact.quality !== "neutral";
}

function Inside({ report, station }: { report: StationReport; station: RemoteStation }) {
  const live = station.state === "live";
  const { title, number, unit, note } = doing(report);
  const alarm = report.alarms[0]?.text;
  const event = station.events[0];
  const sensors = sensorFacts(report);
  return (
    <>
      <div>
        <p className={styles.kind}>
          {live ? t(KINDS[report.activity.kind]) : t("ui-as-of", { when: moment(report.at) })}
        </p>
        <p className={styles.what}>
          {number || title} {unit && <span>{unit}</span>}
        </p>
        <p className={styles.note}>{note}</p>
      </div>
      {live && alarm && (
        <p className={styles.alarm} data-quality={report.alarms[0]?.quality}>
          {station.alarms > 1 ? t("ui-alarm-and-more", { alarm, n: station.alarms - 1 }) : alarm}
        </p>
      )}
      <dl className={styles.facts}>
        {facts(report, 0)
          .filter(isRelevant)
          .filter((fact) => !sensors.some((sensor) => sensor.id === fact.id))
          .map((fact) => (
            <ShownFact key={fact.id} fact={fact} live={live} />
          ))}
      </dl>
      {sensors.length > 0 && (
        <dl className={styles.sensors}>
          {sensors.map((sensor) => (
            <ShownFact key={sensor.id} fact={sensor} live={live} withNote />
          ))}
        </dl>
      )}
      {event && (
        <p className={styles.event}>
          {moment(event.at).slice(11)} {event.text}
        </p>
      )}
    </>
  );
}

/** One fact; quality marks only what is live and needs attention. */
function ShownFact({ fact, live, withNote }: { fact: Fact; live: boolean; withNote?: boolean }) {
  return (
    <div data-quality={live ? fact.quality : "neutral"}>
      <dt>{fact.label}</dt>
      <dd>
        {live && (fact.quality === "bad" || fact.quality === "attention") && (
          <QualityMark quality={fact.quality} size="0.9em" />
        )}
        {fact.value}
      </dd>
      {withNote && <dd className={styles.under}>{fact.note}</dd>}
    </div>
  );
}
