import { useState } from "react";
import type { DriftPeriod, FleetDrift, FleetOverview } from "../api/wire";
import { figures, moment } from "../parts/format";
import { QualityMark } from "../parts/QualityMark";
import { t } from "../state/language";
import { useAnswer } from "./answers";
import { DriftChart } from "./DriftChart";
import styles from "./FleetPage.module.css";

const FIRST = "location-scan";

/** A figure of all stations over time, its changes, and the recordings that they affect. */
export function DriftView({ overview }: { overview: FleetOverview }) {
  const { quantities } = overview;
  const [quantity, setQuantity] = useState(quantities.includes(FIRST) ? FIRST : (quantities[0] ?? ""));
  if (!quantity) return <p className={styles.note}>{t("ui-no-data-yet")}</p>;
  return (
    <section aria-label={t("ui-fleet-drift")}>
      <div className={styles.form}>
        <label>
          {t("ui-fleet-quantity")}
          <select value={quantity} onChange={(event) => setQuantity(event.target.value)}>
            {quantities.map((one) => (
              <option key={one} value={one}>
                {one}
              </option>
            ))}
          </select>
        </label>
      </div>
      <Charts key={quantity} quantity={quantity} names={new Map(overview.stations.map((one) => [one.id, one.name]))} />
    </section>
  );
}

function Charts({ quantity, names }: { quantity: string; names: Map<string, string> }) {
  const { value } = useAnswer<FleetDrift>(`/api/fleet/drift/${encodeURIComponent(quantity)}`);
  if (!value) return null;
  const points = value.stations.flatMap((one) => one.points);
  const known = points.flatMap(({ value, limit }) => [value, ...(limit === null ? [] : [limit])]);
  const times = points.map(({ at }) => Date.parse(at));
  const range = {
    from: Math.min(...times),
    to: Math.max(...times),
    low: Math.min(...known),
    high: Math.max(...known),
  };
  return value.stations.map((one) => (
    <article key={one.station} className={styles.drift}>
      <h2>{names.get(one.station) ?? one.station}</h2>
      <DriftChart points={one.points} changes={one.changes} range={range} label={`${one.station} ${quantity}`} />
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
