import { useState } from "react";
import type { CalibrationPoint } from "../api/wire";
import { decimalsBeside, limitBeside } from "../controls/limits";
import { Segments } from "../controls/Segments";
import { TimeChart } from "../controls/TimeChart";
import { type PlainId, quantity } from "../messages/text";
import { t } from "../state/language";
import { go } from "../state/router";
import { useList } from "../state/useList";
import styles from "./History.module.css";

interface Measure {
  label: PlainId;
  unit: string;
  explanation: PlainId;
  /** A change since the previous calibration. */
  since?: boolean;
  value: (point: CalibrationPoint) => number | null;
  limit: (point: CalibrationPoint) => number | null;
}

const TOTAL: Measure = {
  label: "ui-uncertainty",
  unit: "µm",
  explanation: "ui-standard-uncertainty-dashed-good",
  value: (point) => point.total_um,
  limit: (point) => point.good_um,
};
const MEASURES: Record<string, Measure> = {
  total: TOTAL,
  sensor_um: {
    label: "ui-sensor-shift",
    unit: "µm",
    explanation: "ui-shift-centre-measuring-volume-frame-arms",
    since: true,
    value: (point) => point.sensor_um,
    limit: (point) => point.expected_um,
  },
  sensor_arcsec: {
    label: "ui-sensor-rotation",
    unit: "″",
    explanation: "ui-rotation-of-the-measuring-volume",
    since: true,
    value: (point) => point.sensor_arcsec,
    limit: (point) => point.expected_arcsec,
  },
  plane_um: {
    label: "ui-laser-shift",
    unit: "µm",
    explanation: "ui-shift-laser-plane-along-normal",
    since: true,
    value: (point) => point.plane_um,
    limit: (point) => point.expected_um,
  },
  plane_arcsec: {
    label: "ui-laser-rotation",
    unit: "″",
    explanation: "ui-rotation-of-the-laser-plane",
    since: true,
    value: (point) => point.plane_arcsec,
    limit: (point) => point.expected_arcsec,
  },
  temperature: {
    label: "ui-temperature",
    unit: "°C",
    explanation: "ui-temperature-at-acceptance",
    value: (point) => point.temperature_c,
    limit: () => null,
  },
};

/** The history of the sensor of the newest calibration on its arm, one quantity at a time. */
export function CalibrationHistory() {
  const { list } = useList<CalibrationPoint>("/api/calibration-history");
  const [selected, setSelected] = useState("total");
  const newest = list?.[list.length - 1];
  if (!list || !newest) return null;
  const own = list.filter((p) => p.arm_serial === newest.arm_serial && p.sensor_serial === newest.sensor_serial);
  if (own.length < 2) {
    return <p className={styles.first}>{t("ui-changes-between-calibrations-appear-second-one")}</p>;
  }
  const measures = Object.entries(MEASURES).filter(([, { value }]) => own.some((point) => value(point) !== null));
  const measure = MEASURES[selected] ?? TOTAL;
  const points = own.map((point) => {
    const [value, limit] = [measure.value(point), measure.limit(point)];
    const beyond = value !== null && limit !== null && value > limit;
    return { id: point.id, at: point.accepted_at, value, limit, quality: judged(selected, point, beyond) };
  });
  return (
    <div className={styles.history}>
      <div className={styles.choice}>
        <Segments
          value={selected}
          onChange={setSelected}
          options={measures.map(([name, { label }]) => ({ value: name, label: t(label) }))}
          label={t("ui-plotted-quantity")}
        />
      </div>
      <TimeChart
        points={points}
        unit={measure.unit}
        label={t("ui-over-time", { figure: t(measure.label) })}
        onPoint={(id) => go("records", `calibration/${id}`)}
      />
      <p className={styles.words}>
        {explained(measure)}. {latest(points[points.length - 1], measure)}
      </p>
    </div>
  );
}

type Point = { value: number | null; limit: number | null };

function judged(selected: string, point: CalibrationPoint, beyond: boolean) {
  if (selected === "total") return point.verdict;
  if (selected === "temperature") return "neutral";
  return beyond ? "attention" : "good";
}

function explained({ explanation, since }: Measure): string {
  if (!since) return t(explanation);
  return `${t(explanation)}, ${t("ui-against-previous-calibration-dashed-uncertainties-both")}`;
}

function latest(last: Point | undefined, { unit, label }: Measure): string {
  if (!last || last.value === null) return "";
  const usual = last.value < 10 ? 1 : 0;
  const shown = quantity(last.value, unit, decimalsBeside(last.value, last.limit, usual));
  const value = t("ui-latest", { figure: t(label), value: shown });
  if (last.limit === null) return `${value}.`;
  const limit = limitBeside(last.limit, unit, usual, last.value);
  return `${value}, ${last.value > last.limit ? t("ui-beyond", { limit }) : t("ui-within", { limit })}.`;
}
