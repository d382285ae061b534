import type { DriftPeriod, FleetDrift, FleetOverview } from "../api/wire";
import { figures, moment } from "../parts/format";
import { QualityMark } from "../parts/QualityMark";
import { t } from "../state/language";
import { useAnswer } from "./answers";
import { ChooseQuantity, quantityName, useQuantity } from "./ChooseQuantity";
import { DriftChart } from "./DriftChart";
import styles from "./FleetPage.module.css";
import { rangeOf } from "./Plot";

const FIRST = "location-scan";

/** A figure of all stations over time, its changes, and the recordings that they affect. */
export function DriftView({ overview }: { overview: FleetOverview }) {
  const { quantities } = overview;
  const [quantity, setQuantity] = useQuantity(quantities, FIRST);
  if (!quantity) return <p className={styles.note}>{t("ui-no-data-yet")}</p>;
  return (
    <section aria-label={t("ui-fleet-drift")}>
      <div className={styles.form}>
        <ChooseQuantity known={quantities} value={quantity} onChange={setQuantity} />
      </div>
      <Charts key={quantity} quantity={quantity} overview={overview} />
    </section>
  );
}

function Charts({ quantity, overview }: { quantity: string; overview: FleetOverview }) {
  const { value } = useAnswer<FleetDrift>(`/api/fleet/drift/${encodeURIComponent(quantity)}`);
  if (!value) return null;
  const names = new Map(overview.stations.map((one) => [one.id, one.name]));
  const points = value.stations.flatMap((one) => one.points);
  const range = rangeOf(
    points.map((one) => ({ x: Date.parse(one.at), y: one.value })),
    points.flatMap(({ limit }) => (limit === null ? [] : [limit])),
  );
  const title = quantityName(overview.quantities, quantity);
  return value.stations.map((one) => (
    <article key={one.station} className={styles.drift}>
      <h2>{names.get(one.station) ?? one.station}</h2>
      <DriftChart points={one.points} changes={one.changes} range={range} label={`${one.station}: ${title}`} />
      {value.periods
        .filter((period) => period.station === one.station)
        .map((period) => (
          <Affected key={period.change.by} period={period} unit={one.points[0]?.unit ?? ""} />
        ))}
    </article>
  ));
}

function Affected({ period, unit }: { period: DriftPeriod; unit: string }) {
  const { change, ended, calibration_ids, recordings, possible } = period;
  const size = change.after_value - change.before_value;
  return (
    <div className={styles.affected}>
      <p>
        <QualityMark quality="attention" size="1.1em" />{" "}
        {t("ui-fleet-changed", {
          size: `${size > 0 ? "+" : ""}${figures(size, 1)}`,
          uncertainty: figures(2 * change.standard_uncertainty, 1),
          unit,
          earliest: moment(change.earliest),
          latest: moment(change.latest),
        })}{" "}
        {ended ? t("ui-fleet-ended", { when: moment(ended.by) }) : t("ui-fleet-lasts")}
      </p>
      {calibration_ids.length > 0 && <p>{t("ui-fleet-explained", { calibrations: calibration_ids.join(", ") })}</p>}
      <details>
        <summary>
          {t("ui-fleet-affected", { n: recordings.length })}
          {possible.length > 0 && ` ${t("ui-fleet-possible", { n: possible.length })}`}
        </summary>
        <ul className={styles.recordings}>
          {[...recordings, ...possible].map((one) => (
            <li key={one.id}>{`${moment(one.at)} · ${one.label || one.id}`}</li>
          ))}
        </ul>
      </details>
    </div>
  );
}
