import { useState } from "react";
import type { AgeingSlope, FleetAgeing, FleetOverview, FleetStationAgeing } from "../api/wire";
import { Chips } from "../controls/Chips";
import { figures, moment } from "../controls/format";
import { measured } from "../controls/lengths";
import { QualityMark } from "../controls/QualityMark";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";
import { decimalsOf, useAnswer } from "./answers";
import { ChooseQuantity, quantityName, useQuantity } from "./ChooseQuantity";
import styles from "./FleetPage.module.css";
import { Dot, Plot, type Range, rangeOf } from "./Plot";

type Against = "hours" | "temperature";
const FIRST = "gauge-offset";
const AXES: Record<Against, Record<FleetStationAgeing["since"], PlainId>> = {
  hours: { calibration: "ui-fleet-hours-since-calibration", first: "ui-fleet-hours-since-first" },
  temperature: {
    calibration: "ui-fleet-temperature-since-calibration",
    first: "ui-fleet-temperature-since-first",
  },
};

interface Placed {
  x: number;
  y: number;
  title: string;
  group: string;
}

/** A figure of all stations against the hours since the calibration, or against the temperature. */
export function AgeingView({ overview }: { overview: FleetOverview }) {
  const { quantities } = overview;
  const [quantity, setQuantity] = useQuantity(quantities, FIRST);
  const [against, setAgainst] = useState<Against>("hours");
  const { value } = useAnswer<FleetAgeing>(quantity && `/api/fleet/ageing/${encodeURIComponent(quantity)}`);
  if (!quantity) return <p className={styles.note}>{t("ui-no-data-yet")}</p>;
  const names = new Map(overview.stations.map((one) => [one.id, one.name]));
  const placed = new Map((value?.stations ?? []).map((one) => [one.station, placesOf(one, against)]));
  const range = rangeOf([...placed.values()].flat());
  return (
    <section aria-label={t("ui-fleet-ageing")}>
      <div className={styles.form}>
        <ChooseQuantity known={quantities} value={quantity} onChange={setQuantity} />
        <Chips
          label={t("ui-fleet-against")}
          value={against}
          onChange={setAgainst}
          options={[
            { value: "hours", label: t("ui-fleet-hours") },
            { value: "temperature", label: t("ui-temperature") },
          ]}
        />
      </div>
      {value?.quantity === quantity &&
        value.stations.map((one) => (
          <article key={one.station} className={styles.drift}>
            <h2>{names.get(one.station) ?? one.station}</h2>
            <Ageing
              ageing={one}
              against={against}
              range={range}
              points={placed.get(one.station) ?? []}
              label={`${one.station}: ${quantityName(quantities, quantity)}`}
            />
          </article>
        ))}
    </section>
  );
}

function placesOf({ points, unit }: FleetStationAgeing, against: Against): Placed[] {
  return points.flatMap((one) => {
    const x = against === "hours" ? one.hours : one.temperature;
    if (x === null) return [];
    const title = `${moment(one.at)}: ${measured(one.value, unit, decimalsOf(unit))}`;
    return [{ x, y: one.value, title, group: one.group }];
  });
}

function Ageing({
  ageing,
  against,
  range,
  points,
  label,
}: {
  ageing: FleetStationAgeing;
  against: Against;
  range: Range;
  points: Placed[];
  label: string;
}) {
  const { unit, since, left_out } = ageing;
  const hours = against === "hours";
  const slope = hours ? ageing.per_1000_h : ageing.per_kelvin;
  const [axisUnit, decimals] = hours ? ["h", 0] : [since === "first" ? "°C" : "K", 1];
  const axis = t(AXES[against][since]);
  return (
    <>
      {points.length > 0 && (
        <Plot
          range={range}
          unit={unit}
          ends={[measured(range.from, axisUnit, decimals), measured(range.to, axisUnit, decimals), axis]}
          label={label}
        >
          {({ x, y }) => (
            <>
              {points.map((one, number) => (
                <Dot
                  key={`${one.group} ${one.title} ${number}`}
                  x={x(one.x)}
                  y={y(one.y)}
                  quality="faint"
                  title={one.title}
                />
              ))}
              {slope?.is_significant && (
                <Trend points={points} slope={hours ? slope.value / 1000 : slope.value} x={x} y={y} />
              )}
            </>
          )}
        </Plot>
      )}
      <SlopeWords slope={slope} unit={`${unit}/${hours ? "1000 h" : "K"}`} since={since} />
      {left_out > 0 && <p className={styles.note}>{t("ui-fleet-left-out", { n: left_out })}</p>}
    </>
  );
}

/** The slope through the mean of all values. */
function Trend({
  points,
  slope,
  x,
  y,
}: {
  points: Placed[];
  slope: number;
  x: (value: number) => number;
  y: (value: number) => number;
}) {
  const { from, to } = rangeOf(points);
  const middle = points.reduce((sum, one) => sum + one.x, 0) / points.length;
  const level = points.reduce((sum, one) => sum + one.y, 0) / points.length;
  const at = (place: number) => level + slope * (place - middle);
  return <line className={styles.trend} x1={x(from)} y1={y(at(from))} x2={x(to)} y2={y(at(to))} />;
}

function SlopeWords({ slope, unit, since }: { slope: AgeingSlope | null; unit: string; since: string }) {
  if (!slope) return <p className={styles.note}>{t("ui-fleet-no-slope")}</p>;
  const digits = Math.max(0, 1 - Math.floor(Math.log10(Math.max(slope.expanded_uncertainty, 1e-6))));
  const values = {
    slope: `${slope.value > 0 ? "+" : ""}${figures(slope.value, digits)}`,
    uncertainty: figures(slope.expanded_uncertainty, digits),
    unit,
    since,
    n: slope.values,
    groups: slope.groups,
  };
  if (!slope.is_significant) return <p className={styles.note}>{t("ui-fleet-no-change-shown", values)}</p>;
  return (
    <p className={styles.now}>
      <QualityMark quality="attention" size="1.1em" /> {t("ui-fleet-changes-by", values)}
    </p>
  );
}
