import { type KeyboardEvent, useState } from "react";
import type { CloudLine, CloudMap, MapFile, OutlierPart } from "../../api/wire";
import { Chips } from "../../controls/Chips";
import { DEVIATION_CSS, deviationColour } from "../../controls/deviationColours";
import { lengthFigures, measured, signedLength, unitOf } from "../../controls/lengths";
import { reachesOf } from "../../controls/reaches";
import { quantity } from "../../messages/text";
import { t } from "../../state/language";
import { useRead } from "../../state/useRead";
import styles from "./DeviationMap.module.css";

interface DeviationMapProps {
  clouds: CloudLine[];
  shape: "plane" | "sphere";
}

/** Deviations of a cloud from the fitted shape, seen from outside; all clouds have one scale. */
export function DeviationMap({ clouds, shape }: DeviationMapProps) {
  const [chosen, setChosen] = useState<number | null>(null);
  const last = clouds[clouds.length - 1];
  const cloud = clouds.find(({ number }) => number === chosen) ?? last;
  const all = clouds.map(({ number }) => `of=${number}`).join("&");
  const { value: found, failed } = useRead<CloudMap>(cloud ? `${cloud.map_url}?${all}` : "");
  if (!cloud) return <p className={styles.note}>{t("ui-map-appears-after-first-cloud")}</p>;
  return (
    <div className={styles.view}>
      <Chips
        label={t("ui-clouds")}
        options={clouds.map(({ number }) => ({ value: number, label: t("ui-cloud-n", { n: number }) }))}
        value={cloud.number}
        onChange={setChosen}
      />
      {found ? (
        <CloudDrawing key={cloud.number} {...found} range_um={cloud.range_all_um} shape={shape} />
      ) : (
        <p className={styles.note}>{failed ? t("ui-the-map-could-not-be-loaded") : t("ui-loading-the-map")}</p>
      )}
    </div>
  );
}

type DrawingProps = CloudMap & { range_um: number | null; shape: DeviationMapProps["shape"] };

function CloudDrawing({ map, end_um, range_um, shape }: DrawingProps) {
  const outliers = map.outliers ?? [];
  const [chosen, setChosen] = useState<OutlierPart | null>(null);
  return (
    <>
      <Cells map={map} end_um={end_um} outliers={outliers} chosen={chosen} onChoose={setChosen} />
      <p className={styles.outliers} aria-live="polite">
        {chosen ? outlierText(chosen) : outliersText(map, range_um)}
      </p>
      <Legend map={map} end_um={end_um} shape={shape} />
    </>
  );
}

interface CellsProps {
  map: MapFile;
  end_um: number;
  outliers: OutlierPart[];
  chosen: OutlierPart | null;
  onChoose: (outlier: OutlierPart) => void;
}

/** A ring's radius, as a share of the map's smaller side. */
const RING = 0.018;

function Cells({ map, end_um, outliers, chosen, onChoose }: CellsProps) {
  const { cell_mm: cell, x_mm, y_mm, deviation_um } = map;
  const all_x = [...x_mm, ...outliers.map((one) => one.x_mm)];
  const all_y = [...y_mm, ...outliers.map((one) => one.y_mm)];
  const low_x = Math.min(...all_x) - cell;
  const low_y = Math.min(...all_y) - cell;
  const width = Math.max(...all_x) + cell - low_x;
  const height = Math.max(...all_y) + cell - low_y;
  const radius = RING * Math.min(width, height);
  /* the furthest lie on top */
  const drawn = outliers.toReversed();
  const reaches = reachesOf(
    drawn.map((one) => [one.x_mm, one.y_mm]),
    2.2 * radius,
  );
  return (
    <svg
      className={styles.map}
      viewBox={`${low_x} ${-low_y - height} ${width} ${height}`}
      role="group"
      aria-label={t("ui-deviations-from-the-fitted-shape")}
    >
      <g shapeRendering="crispEdges">
        {x_mm.map((x, i) => (
          <rect
            key={i}
            x={x - cell / 2}
            y={-(y_mm[i] ?? 0) - cell / 2}
            width={cell * 1.02}
            height={cell * 1.02}
            fill={deviationColour((deviation_um[i] ?? 0) / end_um)}
          />
        ))}
      </g>
      {drawn.map((one, i) => (
        <Outlier
          key={`${one.x_mm} ${one.y_mm}`}
          outlier={one}
          radius={radius}
          reach={reaches[i] ?? 0}
          colour={deviationColour(one.deviation_um / end_um)}
          chosen={one === chosen}
          onChoose={() => onChoose(one)}
        />
      ))}
    </svg>
  );
}

interface OutlierProps {
  outlier: OutlierPart;
  radius: number;
  /** Where a press is one of this outlier. */
  reach: number;
  colour: string;
  chosen: boolean;
  onChoose: () => void;
}

function Outlier({ outlier, radius, reach, colour, chosen, onChoose }: OutlierProps) {
  const onKey = (event: KeyboardEvent) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    onChoose();
  };
  return (
    <g
      className={styles.outlier}
      transform={`translate(${outlier.x_mm} ${-outlier.y_mm})`}
      role="button"
      tabIndex={0}
      aria-label={outlierText(outlier)}
      aria-pressed={chosen}
      data-end={outlier.is_end || undefined}
      onClick={onChoose}
      onKeyDown={onKey}
    >
      <circle r={reach} className={styles.reach} />
      <circle r={2.2 * radius} className={styles.focus} />
      <circle r={radius} fill={colour} className={styles.ring} />
    </g>
  );
}

/** What one outlier is, and where the operator finds it. */
function outlierText({ deviation_um, at_mm, frame, points, is_end }: OutlierPart): string {
  return t("ui-outlier-at", {
    deviation: signedLength(deviation_um, "µm", 1),
    end: is_end ? (deviation_um > 0 ? "highest" : "lowest") : "none",
    points,
    at: at_mm.map((value) => lengthFigures(value, "mm", 2)).join("; "),
    unit: unitOf("mm"),
    frame: String(frame),
  });
}

/** Where the range of all points comes from. */
function outliersText({ outliers, outlier_points }: MapFile, range_um: number | null): string {
  const ends = (outliers ?? []).filter(({ is_end }) => is_end).map(({ deviation_um }) => deviation_um);
  if (ends.length === 0 || range_um === null) return "";
  return t("ui-map-outliers", {
    points: outlier_points ?? 0,
    range: measured(range_um, "µm", 1),
    low: signedLength(Math.min(...ends), "µm", 1),
    high: signedLength(Math.max(...ends), "µm", 1),
  });
}

function Legend({ map, end_um, shape }: { map: MapFile; end_um: number; shape: DeviationMapProps["shape"] }) {
  return (
    <div className={styles.legend}>
      <span>−{lengthFigures(end_um, "µm")}</span>
      <span className={styles.ramp} style={{ background: DEVIATION_CSS }} />
      <span>+{measured(end_um, "µm")}</span>
      <span className={styles.explanation}>
        {shape === "plane" ? t("ui-fitted-plane-outward-positive") : t("ui-fitted-sphere-outward-positive")};{" "}
        {t("ui-cell-mean-points", { size: quantity(map.cell_mm, "mm", 1) })}
      </span>
    </div>
  );
}
