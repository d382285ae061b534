import type { FleetCalibrationSpread, FleetOverview, FleetSpread } from "../api/wire";
import { figures, moment } from "../controls/format";
import { measured } from "../controls/lengths";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { decimalsOf, useAnswer } from "./answers";
import { ChooseQuantity, useQuantity } from "./ChooseQuantity";
import styles from "./FleetPage.module.css";
import { Dot } from "./Plot";
import look from "./SpreadTable.module.css";

const FIRST = "point-uncertainty";
const WIDTH = 1000;
const HEIGHT = 40;
const MIDDLE = HEIGHT / 2;

interface Ends {
  low: number;
  high: number;
}

/** A figure of all calibrations of every station and sensor, on one scale. */
export function SpreadTable({ overview }: { overview: FleetOverview }) {
  const known = overview.quantities.filter((one) => one.of_calibrations);
  const [quantity, setQuantity] = useQuantity(known, FIRST);
  const { value } = useAnswer<FleetSpread>(quantity && `/api/fleet/spread/${encodeURIComponent(quantity)}`);
  const spreads = value?.quantity === quantity ? value.spreads : [];
  const unit = spreads[0]?.unit ?? "";
  const decimals = decimalsOf(unit);
  const names = new Map(overview.stations.map((one) => [one.id, one.name]));
  const all = spreads.flatMap((one) => one.values.map((each) => each.value));
  const ends = { low: Math.min(...all), high: Math.max(...all) };
  if (!quantity) return null;
  return (
    <section aria-label={t("ui-fleet-spread")}>
      <div className={styles.form}>
        <ChooseQuantity known={known} value={quantity} onChange={setQuantity} />
      </div>
      {spreads.length > 0 && (
        <div className={styles.scroll}>
          <p className={look.legend}>{t("ui-fleet-all-calibrations")}</p>
          <table className={styles.table}>
            <thead>
              <tr>
                <th scope="col">{t("ui-station")}</th>
                <th scope="col">{t("ui-sensor")}</th>
                <th scope="col" className={look.strip}>
                  <span className={look.ends}>
                    <span>{measured(ends.low, unit, decimals)}</span>
                    <span>{measured(ends.high, unit, decimals)}</span>
                  </span>
                </th>
                <th scope="col">{t("ui-fleet-median")}</th>
                <th scope="col" className={styles.wraps}>
                  {t("ui-fleet-standard-deviation")}
                </th>
                <th scope="col">{t("ui-fleet-newest-value")}</th>
                <th scope="col">{t("ui-fleet-count")}</th>
              </tr>
            </thead>
            <tbody>
              {spreads.map((one) => (
                <Row
                  key={`${one.station} ${one.sensor_serial}`}
                  spread={one}
                  name={names.get(one.station) ?? one.station}
                  ends={ends}
                />
              ))}
            </tbody>
          </table>
        </div>
      )}
    </section>
  );
}

function Row({ spread, name, ends }: { spread: FleetCalibrationSpread; name: string; ends: Ends }) {
  const { unit, values, median, standard_deviation } = spread;
  const decimals = decimalsOf(unit);
  const newest = values[values.length - 1];
  return (
    <tr>
      <th scope="row">{isolated(name)}</th>
      <td>{spread.sensor_serial}</td>
      <td className={look.strip}>
        <Strip spread={spread} ends={ends} label={`${name} ${spread.sensor_serial}`} />
      </td>
      <td>{measured(median, unit, decimals)}</td>
      <td>{standard_deviation === null ? "–" : measured(standard_deviation, unit, decimals)}</td>
      <td title={newest && moment(newest.at)}>{newest ? measured(newest.value, unit, decimals) : "–"}</td>
      <td>{figures(values.length)}</td>
    </tr>
  );
}

/** A dot for each calibration, the newest one larger; a bar of one standard deviation around the median. */
function Strip({ spread, ends, label }: { spread: FleetCalibrationSpread; ends: Ends; label: string }) {
  const { values, median, unit, limit } = spread;
  const reach = Math.max(ends.high - ends.low, 1e-9);
  const x = (value: number) => 12 + ((WIDTH - 24) * (value - ends.low)) / reach;
  const deviation = spread.standard_deviation ?? 0;
  const from = Math.max(x(median - deviation), 0);
  return (
    <svg
      className={look.picture}
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      preserveAspectRatio="none"
      role="img"
      aria-label={label}
    >
      <line className={look.axis} x1="0" x2={WIDTH} y1={MIDDLE} y2={MIDDLE} />
      <rect
        className={look.deviation}
        x={from}
        width={Math.min(x(median + deviation), WIDTH) - from}
        y="8"
        height={HEIGHT - 16}
      />
      <line className={look.median} x1={x(median)} x2={x(median)} y1="4" y2={HEIGHT - 4} />
      {limit !== null && limit <= ends.high && (
        <line className={styles.limit} x1={x(limit)} x2={x(limit)} y1="0" y2={HEIGHT} />
      )}
      {values.map((one, number) => (
        <Dot
          key={one.id}
          x={x(one.value)}
          y={MIDDLE}
          quality="faint"
          newest={number === values.length - 1}
          title={`${moment(one.at)}: ${measured(one.value, unit, decimalsOf(unit))}`}
        />
      ))}
    </svg>
  );
}
