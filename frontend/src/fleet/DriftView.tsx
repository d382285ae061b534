import { useState } from "react";
import type { FleetDrift, FleetOverview } from "../api/wire";
import { t } from "../state/language";
import { useAnswer } from "./answers";
import { ChooseQuantity, quantityName, useQuantity } from "./ChooseQuantity";
import { AffectedPeriod, DriftNotes } from "./DriftAnswer";
import { DriftChart } from "./DriftChart";
import styles from "./FleetPage.module.css";
import { type Range, rangeOf } from "./Plot";
import { RightLevel } from "./RightLevel";

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
  const { value } = useAnswer<FleetDrift>(addressOf(quantity));
  if (!value) return null;
  const names = new Map(overview.stations.map((one) => [one.id, one.name]));
  const points = value.stations.flatMap((one) => one.points);
  const range = rangeOf(
    points.map((one) => ({ x: Date.parse(one.at), y: one.value })),
    points.flatMap(({ limit }) => (limit === null ? [] : [limit])),
  );
  return (
    <>
      <p className={styles.note}>{t("ui-fleet-least-values", { n: value.least_values })}</p>
      {value.stations.map(({ station }) => (
        <StationCard
          key={station}
          station={station}
          name={names.get(station) ?? station}
          title={quantityName(overview.quantities, quantity)}
          drift={value}
          range={range}
        />
      ))}
    </>
  );
}

/** The figure of one station; another level than the proposed one can be taken as right. */
function StationCard(card: { station: string; name: string; title: string; drift: FleetDrift; range: Range }) {
  const { station, name, title, drift, range } = card;
  const [since, setSince] = useState("");
  const { value: chosen } = useAnswer<FleetDrift>(since && addressOf(drift.quantity, { station, right_since: since }));
  const { stations, periods, doubted } = (since && chosen) || drift;
  const found = stations.find((one) => one.station === station);
  if (!found) return null;
  const { points, history } = found;
  const unit = points[0]?.unit ?? "";
  return (
    <article className={styles.drift}>
      <h2>{name}</h2>
      <DriftChart points={points} history={history} range={range} label={`${station}: ${title}`} />
      {history.levels.length > 1 && <RightLevel history={history} unit={unit} since={since} onChange={setSince} />}
      <DriftNotes
        history={history}
        least={drift.least_values}
        unit={unit}
        doubted={doubted.filter((one) => one.station === station)}
      />
      {periods
        .filter((period) => period.station === station)
        .map((period) => (
          <AffectedPeriod key={period.levels[0]?.since} period={period} unit={unit} />
        ))}
    </article>
  );
}

function addressOf(quantity: string, query: Record<string, string> = {}): string {
  const asked = new URLSearchParams(query).toString();
  return `/api/fleet/drift/${encodeURIComponent(quantity)}${asked && `?${asked}`}`;
}
