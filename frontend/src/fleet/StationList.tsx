import type { FleetStation, StationsOnBroker } from "../api/wire";
import { figures, moment } from "../controls/format";
import { QualityMark } from "../controls/QualityMark";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { doing, stationState } from "../supervise/stationFacts";
import { sizeOf, useAnswer } from "./answers";
import styles from "./FleetPage.module.css";

const READ_MS = 2000;

/** The stations of the catalogue with what they do now, and the state of their archives. */
export function StationList({ stations, place }: { stations: FleetStation[]; place: string }) {
  const { value: heard } = useAnswer<StationsOnBroker>("/api/fleet/stations", READ_MS);
  const live = new Map((heard?.stations ?? []).map((one) => [one.id, one]));
  const known = new Set(stations.map((one) => one.id));
  const others = [...live.values()].filter((one) => !known.has(one.id));
  return (
    <section aria-label={t("ui-stations")}>
      <ul className={styles.cards}>
        {stations.map((station) => (
          <StationCard
            key={station.id}
            station={station}
            remote={live.get(station.id)}
            isHeard={heard?.broker === true}
          />
        ))}
        {others.map((remote) => (
          <li key={remote.id} className={styles.card}>
            <h2>{isolated(remote.name)}</h2>
            <Now remote={remote} />
            <p className={styles.note}>{t("ui-fleet-not-collected")}</p>
          </li>
        ))}
      </ul>
      {heard?.broker === false && <p className={styles.trouble}>{t("ui-fleet-broker-away")}</p>}
      <p className={styles.note}>{t("ui-fleet-place", { place })}</p>
    </section>
  );
}

function StationCard({
  station,
  remote,
  isHeard,
}: {
  station: FleetStation;
  remote: StationsOnBroker["stations"][number] | undefined;
  /** There is a broker, on which stations are heard. */
  isHeard: boolean;
}) {
  const waiting = station.records - station.archived;
  return (
    <li className={styles.card} data-problem={station.problem ? true : undefined}>
      <h2>{isolated(station.name)}</h2>
      {remote && <Now remote={remote} />}
      {isHeard && !remote && <p className={styles.note}>{t("ui-fleet-not-on-broker")}</p>}
      <dl className={styles.facts}>
        <dt>{t("ui-fleet-records")}</dt>
        <dd>{figures(station.records)}</dd>
        <dt>{t("ui-fleet-only-on-station")}</dt>
        <dd>{figures(waiting)}</dd>
        <dt>{t("ui-fleet-size")}</dt>
        <dd>{sizeOf(station.size_bytes)}</dd>
        <dt>{t("ui-fleet-newest")}</dt>
        <dd>{station.newest_at ? moment(station.newest_at) : "–"}</dd>
        <dt>{t("ui-fleet-collected")}</dt>
        <dd>{station.collected_at ? moment(station.collected_at) : "–"}</dd>
      </dl>
      {station.problem && (
        <p className={styles.trouble}>
          <QualityMark quality="attention" size="1.1em" /> {station.problem}
        </p>
      )}
    </li>
  );
}

function Now({ remote }: { remote: StationsOnBroker["stations"][number] }) {
  const { words, quality } = stationState(remote);
  const activity = remote.state === "live" && remote.report ? doing(remote.report) : null;
  return (
    <p className={styles.now}>
      <QualityMark quality={quality} size="1.1em" /> {words}
      {activity && ` · ${activity.number ? `${activity.number} ${activity.unit}` : activity.title}`}
      {remote.report?.address && (
        <a href={remote.report.address} rel="noreferrer">
          {t("ui-open")}
        </a>
      )}
    </p>
  );
}
