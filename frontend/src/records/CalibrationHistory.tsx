import { useState } from "react";

import type { CalibrationPoint } from "../api/recordTypes";
import { Segments } from "../parts/Segments";
import { TimeChart } from "../parts/TimeChart";
import { bound } from "../parts/format";
import { measured } from "../parts/lengths";
import { t, words } from "../state/language";
import { go } from "../state/router";
import { useList } from "../state/useList";
import styles from "./CalibrationHistory.module.css";

interface Measure {
  label: string;
  unit: string;
  words: string;
  /** It is a change since the calibration before. */
  since?: boolean;
  value: (point: CalibrationPoint) => number | null;
  limit: (point: CalibrationPoint) => number | null;
}

const MEASURES: Record<string, Measure> = {
  total: {
    label: words("Uncertainty"),
    unit: "µm",
    words: words("Standard uncertainty of a scanned point, k = 1; dashed: good up to there"),
    value: (point) => point.total_um,
    limit: (point) => point.good_um,
  },
  sensor_um: {
    label: words("Sensor shift"),
    unit: "µm",
    words: words("Shift of the middle of the measuring volume in the frame of the arm's last joint"),
    since: true,
    value: (point) => point.sensor_um,
    limit: (point) => point.expected_um,
  },
  sensor_arcsec: {
    label: words("Sensor turn"),
    unit: "″",
    words: words("Turn of the measuring volume"),
    since: true,
    value: (point) => point.sensor_arcsec,
    limit: (point) => point.expected_arcsec,
  },
  plane_um: {
    label: words("Laser shift"),
    unit: "µm",
    words: words("Shift of the laser plane along its normal"),
    since: true,
    value: (point) => point.plane_um,
    limit: (point) => point.expected_um,
  },
  plane_arcsec: {
    label: words("Laser turn"),
    unit: "″",
    words: words("Turn of the laser plane"),
    since: true,
    value: (point) => point.plane_arcsec,
    limit: (point) => point.expected_arcsec,
  },
  temperature: {
    label: words("Temperature"),
    unit: "°C",
    words: words("Temperature at acceptance"),
    value: (point) => point.temperature_c,
    limit: () => null,
  },
};

/** What became of the newest calibration's sensor on its arm, one figure at a time. */
export function CalibrationHistory() {
  const { list } = useList<CalibrationPoint>("/api/calibration-history");
  const [shown, setShown] = useState("total");
  const newest = list?.[list.length - 1];
  if (!list || !newest) return null;
  const own = list.filter((p) => p.arm_serial === newest.arm_serial && p.sensor_serial === newest.sensor_serial);
  if (own.length < 2) {
    return <p className={styles.first}>{t("From the second calibration on, what changed between them is drawn here.")}</p>;
  }
  const names = Object.keys(MEASURES).filter((name) => own.some((point) => MEASURES[name]?.value(point) !== null));
  const measure = MEASURES[shown] ?? MEASURES.total!;
  const points = own.map((point) => {
    const [value, limit] = [measure.value(point), measure.limit(point)];
    const beyond = value !== null && limit !== null && value > limit;
    return { id: point.id, at: point.accepted_at, value, limit, quality: judged(shown, point, beyond) };
  });
  return (
    <div className={styles.history}>
      <div className={styles.choice}>
        <Segments
          value={shown}
          onChange={setShown}
          options={names.map((name) => ({ value: name, label: t(MEASURES[name]?.label ?? name) }))}
          label={t("What is drawn over time")}
        />
      </div>
      <TimeChart
        points={points}
        unit={measure.unit}
        label={t("{figure} over time", { figure: t(measure.label) })}
        onPoint={(id) => go("records", `calibration/${id}`)}
      />
      <p className={styles.words}>{bound(`${explained(measure)}. ${told(points[points.length - 1], measure)}`)}</p>
    </div>
  );
}

type Point = { value: number | null; limit: number | null };

function judged(shown: string, point: CalibrationPoint, beyond: boolean) {
  if (shown === "total") return point.verdict;
  if (shown === "temperature") return "neutral";
  return beyond ? "attention" : "good";
}

function explained({ words: what, since }: Measure): string {
  if (!since) return t(what);
  return `${t(what)}, ${t("against the calibration before; dashed: what the uncertainties of both let expect of a sensor that did not move (k = 2)")}`;
}

function told(last: Point | undefined, { unit, label }: Measure): string {
  if (!last || last.value === null) return "";
  const value = t("{figure} last: {value}", { figure: t(label), value: measured(last.value, unit, last.value < 10 ? 1 : 0) });
  if (last.limit === null) return `${value}.`;
  const limit = measured(last.limit, unit);
  return `${value}, ${last.value > last.limit ? t("beyond {limit}", { limit }) : t("within {limit}", { limit })}.`;
}
