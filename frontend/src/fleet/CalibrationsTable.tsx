import type { CalibrationsInUse } from "../api/wire";
import { figures, moment } from "../controls/format";
import { measured } from "../controls/lengths";
import { QualityMark } from "../controls/QualityMark";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { decimalsOf, qualityOf, useAnswer } from "./answers";
import styles from "./FleetPage.module.css";

/** The newest calibration of every station and sensor, one in each row. */
export function CalibrationsTable({ names }: { names: Map<string, string> }) {
  const { value } = useAnswer<CalibrationsInUse>("/api/fleet/calibrations");
  if (!value) return null;
  const { calibrations } = value;
  const titles = new Map(calibrations.flatMap((one) => one.figures.map(({ quantity, title }) => [quantity, title])));
  if (calibrations.length === 0) return <p className={styles.note}>{t("ui-no-data-yet")}</p>;
  return (
    <section className={styles.scroll} aria-label={t("ui-fleet-newest-calibrations")}>
      <table className={styles.table}>
        <thead>
          <tr>
            <th scope="col">{t("ui-station")}</th>
            <th scope="col">{t("ui-sensor")}</th>
            <th scope="col">{t("ui-time")}</th>
            <th scope="col">{t("ui-temperature")}</th>
            {[...titles].map(([quantity, title]) => (
              <th key={quantity} scope="col" className={styles.wraps}>
                {title}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {calibrations.map((one) => (
            <tr key={`${one.station} ${one.id}`}>
              <th scope="row">{isolated(names.get(one.station) ?? one.station)}</th>
              <td>{one.sensor_serial}</td>
              <td>
                {one.verdict && <QualityMark quality={qualityOf(one.verdict)} size="1em" />} {moment(one.at)}
              </td>
              <td>{one.temperature_c === null ? "–" : `${figures(one.temperature_c, 1)} °C`}</td>
              {[...titles.keys()].map((quantity) => {
                const found = one.figures.find((figure) => figure.quantity === quantity);
                return (
                  <td key={quantity}>{found ? measured(found.value, found.unit, decimalsOf(found.unit)) : "–"}</td>
                );
              })}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}
