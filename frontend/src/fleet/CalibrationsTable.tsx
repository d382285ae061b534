import type { CalibrationsInUse } from "../api/wire";
import { figures, moment } from "../parts/format";
import { measured } from "../parts/lengths";
import { QualityMark } from "../parts/QualityMark";
import { t } from "../state/language";
import { decimalsOf, qualityOf, useAnswer } from "./answers";
import styles from "./FleetPage.module.css";

/** The newest calibration of every station and sensor, side by side. */
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
            <th scope="col">{t("ui-fleet-quantity")}</th>
            {calibrations.map((one) => (
              <th key={`${one.station} ${one.sensor_serial}`} scope="col">
                {names.get(one.station) ?? one.station}
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
          {[...titles].map(([quantity, title]) => (
            <tr key={quantity}>
              <th scope="row">{title}</th>
              {calibrations.map((one) => {
                const found = one.figures.find((figure) => figure.quantity === quantity);
                return (
                  <td key={`${one.station} ${one.id}`}>
                    {found ? measured(found.value, found.unit, decimalsOf(found.unit)) : "–"}
                  </td>
                );
              })}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}
