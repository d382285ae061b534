import { useState } from "react";
import type { CloudLine, MapFile } from "../api/wire";

import { quantity } from "../messages/text";
import { Chips } from "../parts/Chips";
import { lengthFigures, measured } from "../parts/lengths";
import { t } from "../state/language";
import { useRead } from "../state/useRead";
import { DEVIATION_CSS, deviationColour, deviationScale } from "./colours";
import styles from "./DeviationMap.module.css";

/** Deviations of a cloud from the fitted shape, seen from outside. */
export function DeviationMap({ clouds, shape }: { clouds: CloudLine[]; shape: "plane" | "sphere" }) {
  const [chosen, setChosen] = useState<number | null>(null);
  const last = clouds[clouds.length - 1];
  const cloud = clouds.find(({ number }) => number === chosen) ?? last;
  const { value: file, failed } = useRead<MapFile>(cloud?.map_url ?? "");
  if (!cloud) return <p className={styles.note}>{t("ui-map-appears-after-first-cloud")}</p>;
  return (
    <div className={styles.view}>
      <Chips
        label={t("ui-clouds")}
        options={clouds.map(({ number }) => ({ value: number, label: t("ui-cloud-n", { n: number }) }))}
        value={cloud.number}
        onChange={setChosen}
      />
      {file ? (
        <Cells file={file} />
      ) : (
        <p className={styles.note}>{failed ? t("ui-the-map-could-not-be-loaded") : t("ui-loading-the-map")}</p>
      )}
      {file && <Legend file={file} shape={shape} />}
    </div>
  );
}

function Cells({ file }: { file: MapFile }) {
  const { cell_mm: cell, x_mm, y_mm, deviation_um } = file;
  const end = deviationScale(deviation_um);
  const low_x = Math.min(...x_mm) - cell;
  const low_y = Math.min(...y_mm) - cell;
  const width = Math.max(...x_mm) + cell - low_x;
  const height = Math.max(...y_mm) + cell - low_y;
  return (
    <svg
      className={styles.map}
      viewBox={`${low_x} ${-low_y - height} ${width} ${height}`}
      role="img"
      aria-label={t("ui-deviations-from-the-fitted-shape")}
      shapeRendering="crispEdges"
    >
      {x_mm.map((x, i) => (
        <rect
          key={i}
          x={x - cell / 2}
          y={-(y_mm[i] ?? 0) - cell / 2}
          width={cell * 1.02}
          height={cell * 1.02}
          fill={deviationColour((deviation_um[i] ?? 0) / end)}
        />
      ))}
    </svg>
  );
}

function Legend({ file, shape }: { file: MapFile; shape: "plane" | "sphere" }) {
  const end = deviationScale(file.deviation_um);
  return (
    <div className={styles.legend}>
      <span>−{lengthFigures(end, "µm")}</span>
      <span className={styles.ramp} style={{ background: DEVIATION_CSS }} />
      <span>+{measured(end, "µm")}</span>
      <span className={styles.explanation}>
        {shape === "plane" ? t("ui-fitted-plane-outward-positive") : t("ui-fitted-sphere-outward-positive")};{" "}
        {t("ui-cell-mean-points", { size: quantity(file.cell_mm, "mm", 1) })}
      </span>
    </div>
  );
}
