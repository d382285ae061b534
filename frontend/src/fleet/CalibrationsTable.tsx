import type { CalibrationsInUse } from "../api/wire";
import { figures, moment } from "../parts/format";
import { QualityMark } from "../parts/QualityMark";
import { t } from "../state/language";
import { qualityOf, useAnswer } from "./answers";
import styles from "./FleetPage.module.css";

/** The newest calibration of every station and sensor, side by side. */
export function CalibrationsTable() {
  const { value } = useAnswer<CalibrationsInUse>("/api/fleet/calibrations");
  if (!value) return null;
  const { calibrations } = value;
  const quantities = [...new Set(calibrations.flatMap((one) => one.figures.map(({ quantity }) => quantity)))];
  if (calibrations.length === 0) return <p className={styles.note}>{t("ui-no-data-yet")}</p>;
  return (
    <section className={styles.scroll} aria-label={t("ui-fleet-calibrations")}>
      <table className={styles.table}>
        <thead>
          <tr>
            <th scope="col">{t("ui-fleet-quantity")}</th>
            {calibrations.map((one) => (
              <th key={`${one.station} ${one.sensor_serial}`} scope="col">
                {one.station}
                <br />
                {one.sensor_serial}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          <tr>
            <th scope="row">{t("ui-time")}</th>
            {calibrations.map((one) => (
              <td key={`${one.station} ${one.id}`}>
                {one.verdict && <QualityMark quality={qualityOf(one.verdict)} size="1em" />} {moment(one.at)}
              </td>
            ))}
          </tr>
          <tr>
            <th scope="row">{t("ui-temperature")}</th>
            {calibrations.map((one) => (
              <td key={`${one.station} ${one.id}`}>
                {one.temperature_c === null ? "–" : `${figures(one.temperature_c, 1)} °C`}
              </td>
            ))}
          </tr>
          {quantities.map((quantity) => (
            <tr key={quantity}>
              <th scope="row">{quantity}</th>
              {calibrations.map((one) => {
                const found = one.figures.find((figure) => figure.quantity === quantity);
                return (
                  <td key={`${one.station} ${one.id}`}>{found ? `${figures(found.value, 3)} ${found.unit}` : "–"}</td>
                );
              })}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}
