import type { FleetRecord, FoundFleetRecord } from "../api/wire";
import { figures, moment } from "../controls/format";
import { measured } from "../controls/lengths";
import { decimalsBeside, limitBeside } from "../controls/limits";
import { QualityMark } from "../controls/QualityMark";
import { uncertaintyQuantity } from "../controls/uncertainty";
import { render, t } from "../state/language";
import { decimalsOf, qualityOf, sizeOf, useAnswer } from "./answers";
import styles from "./FleetPage.module.css";
import { kindName } from "./RecordSearch";
import { ScanCloudsPart } from "./ScanCloudsPart";

/** One record with its results and its files. */
export function RecordDetail({
  found,
  station,
  onBack,
}: {
  found: FoundFleetRecord;
  station: string | undefined;
  onBack: () => void;
}) {
  const path = [found.station, found.kind, found.id].map(encodeURIComponent).join("/");
  const { value } = useAnswer<FleetRecord>(`/api/fleet/records/${path}`);
  const entry = value ?? found;
  const facts: [string, string][] = [
    [t("ui-station"), station ?? entry.station],
    [t("ui-time"), moment(entry.at)],
    [t("ui-fleet-label"), entry.label],
    [t("ui-operator"), entry.operator],
    [t("ui-arm"), entry.arm_serial],
    [t("ui-sensor"), entry.sensor_serial],
    [t("ui-fleet-object"), entry.object_serial],
    [t("ui-calibration"), entry.calibration_id],
    [t("ui-temperature"), entry.temperature_c === null ? "" : `${figures(entry.temperature_c, 1)} °C`],
    [t("ui-fleet-software"), entry.software],
    [t("ui-fleet-archived"), entry.archived_at ? moment(entry.archived_at) : t("ui-fleet-only-on-station")],
    [t("ui-fleet-from"), entry.place],
  ];
  return (
    <section aria-label={entry.id}>
      <button type="button" className={styles.more} onClick={onBack}>
        {t("ui-fleet-back")}
      </button>
      <h2 className={styles.heading}>
        {entry.verdict && <QualityMark quality={qualityOf(entry.verdict)} size="1em" />} {kindName(entry.kind)}{" "}
        {entry.id}
      </h2>
      <dl className={styles.detail}>
        {facts
          .filter(([, fact]) => fact)
          .map(([name, fact]) => (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{fact}</dd>
            </div>
          ))}
      </dl>
      {entry.kind === "scan" && <ScanCloudsPart scan={entry} path={`/api/fleet/records/${path}/clouds`} />}
      {entry.figures.length > 0 && (
        <div className={styles.scroll}>
          <table className={styles.table}>
            <thead>
              <tr>
                <th scope="col">{t("ui-fleet-symbol")}</th>
                <th scope="col">{t("ui-fleet-quantity")}</th>
                <th scope="col">{t("ui-value")}</th>
                <th scope="col">{t("ui-fleet-expanded")}</th>
                <th scope="col">{t("ui-limit")}</th>
                <th scope="col">{t("ui-fleet-verdict")}</th>
              </tr>
            </thead>
            <tbody>
              {entry.figures.map((one) => (
                <tr key={`${one.symbol} ${one.quantity}`}>
                  <td>{one.symbol === one.quantity ? "" : one.symbol}</td>
                  <td className={styles.wraps}>{one.title}</td>
                  <td>{measured(one.value, one.unit, decimalsBeside(one.value, one.limit, decimalsOf(one.unit)))}</td>
                  <td>
                    {one.expanded_uncertainty === null
                      ? "–"
                      : render(uncertaintyQuantity(one.expanded_uncertainty, one.unit))}
                  </td>
                  <td>
                    {one.limit === null
                      ? "–"
                      : render(limitBeside(one.limit, one.unit, decimalsOf(one.unit), one.value))}
                  </td>
                  <td>{one.decision && <QualityMark quality={qualityOf(one.decision)} size="1.1em" />}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
      {entry.files.length > 0 && (
        <div className={styles.scroll}>
          <table className={styles.table}>
            <thead>
              <tr>
                <th scope="col">{t("ui-fleet-file")}</th>
                <th scope="col">{t("ui-fleet-size")}</th>
                <th scope="col">SHA-256</th>
              </tr>
            </thead>
            <tbody>
              {entry.files.map((file) => (
                <tr key={file.path}>
                  <td>{file.path}</td>
                  <td>{sizeOf(file.bytes)}</td>
                  <td className={styles.hash}>{file.sha256}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
    </section>
  );
}
