import { useState } from "react";

import { drop, post, Refused } from "../api/http";
import type {
  CalibrationChoice,
  CloudOrderState,
  CloudWish,
  FleetCalibrationDoubt,
  FleetCalibrationDoubts,
  FleetRecord,
  MadeCloud,
  ScanClouds,
} from "../api/wire";
import { Download } from "../controls/Download";
import { figures, moment } from "../controls/format";
import { measured } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { Busy } from "../controls/Progress";
import { QualityMark } from "../controls/QualityMark";
import { t } from "../state/language";
import { decimalsOf, sizeOf, useAnswer } from "./answers";
import styles from "./FleetPage.module.css";

const READ_MS = 1000;
type CloudFormat = CloudOrderState["format"];
const ENDINGS: Record<CloudFormat, string> = { copc: ".copc.laz", ply: ".ply" };

/** The clouds of a scan: those that are there, those that are being made, and how to make one. */
export function ScanCloudsPart({ scan, path }: { scan: FleetRecord; path: string }) {
  const { value } = useAnswer<ScanClouds>(path, READ_MS);
  if (!value) return null;
  return (
    <section aria-label={t("ui-fleet-clouds")}>
      <h3 className={styles.heading}>{t("ui-fleet-clouds")}</h3>
      {value.problem ? (
        <>
          <p className={styles.note}>{value.problem}</p>
          <p className={styles.note}>{t("ui-fleet-cloud")}</p>
          <p className={styles.command}>{rebuildCommand(scan)}</p>
        </>
      ) : (
        <MakeCloud clouds={value} path={path} scan={scan} />
      )}
      {value.orders.map((order) => (
        <Order key={order.id} order={order} used={value.used_calibration_id} />
      ))}
      {value.made.length > 0 && <MadeClouds made={value.made} />}
    </section>
  );
}

function MakeCloud({ clouds, path, scan }: { clouds: ScanClouds; path: string; scan: FleetRecord }) {
  const { calibrations, used_calibration_id: used } = clouds;
  const sensors = sensorsOf(scan, calibrations);
  const [chosen, choose] = useState<Record<string, string>>({});
  const choiceOf = (sensor: string) => chosen[sensor] ?? (sensors.length > 1 ? "" : used);
  const calibration_ids = sensors.map(choiceOf).filter(Boolean);
  const [format, chooseFormat] = useState<CloudFormat>("copc");
  const [problem, setProblem] = useState("");
  const { value: doubted } = useAnswer<FleetCalibrationDoubts>(
    `/api/fleet/calibrations/${encodeURIComponent(scan.station)}/doubts`,
  );
  const doubtsOf = (id: string) => (doubted?.doubts ?? []).filter((one) => one.calibration_id === id);
  const isMade = clouds.made.some(
    (one) =>
      one.software === clouds.software &&
      one.name.endsWith(ENDINGS[format]) &&
      one.calibration_ids.length === sensors.length &&
      one.calibration_ids.every((id) => calibration_ids.includes(id)),
  );
  const make = async () => {
    setProblem("");
    try {
      await post(path, { calibration_ids, format } satisfies Partial<CloudWish>);
    } catch (error) {
      setProblem(error instanceof Refused ? error.problem.detail : t("ui-fleet-no-answer"));
    }
  };
  return (
    <>
      <form className={styles.form} onSubmit={(event) => event.preventDefault()}>
        {sensors.map((sensor) => (
          <label key={sensor}>
            {sensor ? t("ui-fleet-calibration-of-sensor", { sensor }) : t("ui-calibration")}
            <select value={choiceOf(sensor)} onChange={(event) => choose({ ...chosen, [sensor]: event.target.value })}>
              {sensor && <option value="">{t("ui-fleet-calibration-of-its-day")}</option>}
              {calibrations
                .filter((one) => !sensor || one.sensor_serial === sensor)
                .map((one, number) => (
                  <option key={one.id} value={one.id}>
                    {calibrationWords(one, one.id === used, number === 0 && one.at !== null, doubtsOf(one.id))}
                  </option>
                ))}
            </select>
          </label>
        ))}
        <label>
          {t("ui-fleet-cloud-format")}
          <select value={format} onChange={(event) => chooseFormat(event.target.value as CloudFormat)}>
            <option value="copc">COPC</option>
            <option value="ply">PLY</option>
          </select>
        </label>
        <div className={styles.make}>
          <PressButton
            free
            kind="primary"
            disabled={isMade}
            why={isMade ? t("ui-fleet-cloud-is-made") : ""}
            onPress={make}
          >
            {t("ui-fleet-make-cloud")}
          </PressButton>
        </div>
      </form>
      {calibration_ids.flatMap(doubtsOf).map((one) => (
        <p key={`${one.calibration_id} ${one.title}`} className={styles.doubt}>
          <QualityMark quality="attention" size="1.1em" /> {doubtWords(one)}
        </p>
      ))}
      {problem && (
        <p className={styles.problem} role="alert">
          {problem}
        </p>
      )}
    </>
  );
}

function Order({ order, used }: { order: CloudOrderState; used: string }) {
  const calibration = order.calibration_ids.join(", ") || used || "–";
  if (order.state === "failed") {
    return (
      <p className={styles.problem} role="alert">
        {t("ui-fleet-cloud-failed", { calibration, why: order.problem })}
      </p>
    );
  }
  const words = order.state === "waiting" ? "ui-fleet-cloud-waits" : "ui-fleet-cloud-is-being-made";
  return (
    <div className={styles.order}>
      <Busy text={order.note || t(words, { calibration })} fraction={order.share > 0 ? order.share : null} />
      <PressButton free kind="quiet" onPress={async () => void (await drop(`/api/fleet/cloud-orders/${order.id}`))}>
        {t("ui-cancel")}
      </PressButton>
    </div>
  );
}

function MadeClouds({ made }: { made: MadeCloud[] }) {
  return (
    <div className={styles.scroll}>
      <table className={styles.table}>
        <thead>
          <tr>
            <th scope="col">{t("ui-calibration")}</th>
            <th scope="col">{t("ui-fleet-cloud-format")}</th>
            <th scope="col">{t("ui-points")}</th>
            <th scope="col">{t("ui-fleet-size")}</th>
            <th scope="col">{t("ui-fleet-software")}</th>
            <th scope="col">{t("ui-fleet-file")}</th>
          </tr>
        </thead>
        <tbody>
          {made.map((one) => (
            <tr key={one.name}>
              <td className={styles.wraps}>
                {one.calibration_ids.join(", ")}
                {one.warnings.map((warning, number) => (
                  <div key={number} className={styles.note}>
                    {warning}
                  </div>
                ))}
              </td>
              <td>{one.name.endsWith(ENDINGS.copc) ? "COPC" : "PLY"}</td>
              <td>{figures(one.points)}</td>
              <td>{sizeOf(one.size_bytes)}</td>
              <td>{one.software}</td>
              <td>
                <Download href={`/api/fleet/clouds/${encodeURIComponent(one.name)}`}>{t("ui-fleet-download")}</Download>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** The sensors whose calibrations are chosen, each by itself; "" is the only one. A scan of several states no serial number of its own. */
function sensorsOf(scan: FleetRecord, calibrations: CalibrationChoice[]): string[] {
  const known = [...new Set(calibrations.map((one) => one.sensor_serial))].filter(Boolean).sort();
  return scan.sensor_serial || known.length < 2 ? [""] : known;
}

/** A calibration in the list: its name or id, its time, whether it was in use or is the newest, and whether it is doubted. */
function calibrationWords(
  { id, label, at }: CalibrationChoice,
  isUsed: boolean,
  isNewest: boolean,
  doubts: FleetCalibrationDoubt[],
): string {
  const name = [label, id].filter(Boolean).join(", ") || "–";
  const mark = isUsed && isNewest ? "both" : isUsed ? "used" : isNewest ? "newest" : "none";
  const choice = t("ui-fleet-calibration-choice", { name, at: at ? moment(at) : "–", mark });
  if (doubts.length === 0) return choice;
  const doubt = doubts.some((one) => one.is_wrong) ? "wrong" : "perhaps";
  return t("ui-fleet-calibration-doubted", { choice, doubt });
}

function doubtWords({ title, unit, size, is_wrong }: FleetCalibrationDoubt): string {
  const by = `${size > 0 ? "+" : ""}${measured(size, unit, decimalsOf(unit))}`;
  return t("ui-fleet-calibration-doubt", { quantity: title, size: by, doubt: is_wrong ? "wrong" : "perhaps" });
}

/** What makes the cloud of a scan elsewhere. */
function rebuildCommand({ place, id }: FleetRecord): string {
  return `crenel rebuild '${place}' --record '${id}' --format copc -o clouds`;
}
