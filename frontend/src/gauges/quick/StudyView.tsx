import { useEffect, useState } from "react";
import { makeStudy } from "../../api/commands";
import { get } from "../../api/http";
import type { StudyFile, StudyState } from "../../api/wire";
import { CopyCsv } from "../../controls/CopyCsv";
import { PressButton } from "../../controls/PressButton";
import { Busy } from "../../controls/Progress";
import type { Head, TableData } from "../../controls/table";
import { uncertaintyQuantity } from "../../controls/uncertainty";
import { type PlainId, quantity } from "../../messages/text";
import { t } from "../../state/language";
import styles from "./Charts.module.css";
import { LinesChart, RangeBars } from "./LinesChart";

const POLL_MS = 400;
/** Of the calibrations in their order, from blue through violet to orange: suitable for colour-blind users. */
const RAMP: [number, number, number][] = [
  [38, 118, 222],
  [140, 92, 205],
  [214, 92, 118],
  [240, 140, 30],
];

function rampColour(share: number): string {
  const place = Math.min(1, Math.max(0, share)) * (RAMP.length - 1);
  const i = Math.min(RAMP.length - 2, Math.floor(place));
  const low = RAMP[i] ?? [0, 0, 0];
  const high = RAMP[i + 1] ?? low;
  const mix = low.map((value, k) => Math.round(value + ((high[k] ?? value) - value) * (place - i)));
  return `rgb(${mix.join(" ")})`;
}

/** The paper's test: the clouds of one verification, each rebuilt with every calibration. */
export function StudyView({ id }: { id: string }) {
  const { state, begin } = useStudy(id);
  if (!state) return null;
  if (state.running)
    return (
      <div className={styles.begin}>
        <Busy text={state.text || t("ui-rebuilding-the-clouds")} fraction={state.fraction} />
      </div>
    );
  const { study } = state;
  if (!study) {
    return (
      <div className={styles.begin}>
        <h2>{t("ui-the-same-clouds-with-every-calibration")}</h2>
        <p>{t("ui-every-cloud-verification-rebuilt-accepted-calibrations", { n: state.accepted })}</p>
        <PressButton kind="primary" onPress={begin}>
          {t("ui-rebuild-with-calibrations", { n: state.accepted })}
        </PressButton>
      </div>
    );
  }
  return (
    <Charts study={study} newer={state.accepted > study.calibrations.length + study.left_out.length} begin={begin} />
  );
}

function useStudy(id: string) {
  const [state, setState] = useState<StudyState | null>(null);
  const [polls, setPolls] = useState(0);
  // biome-ignore lint/correctness/useExhaustiveDependencies: polled again once it has begun
  useEffect(() => {
    let timer = 0;
    let wanted = true;
    const ask = () =>
      get<StudyState>(`/api/verifications/${id}/study`).then(
        (read) => {
          if (!wanted) return;
          setState(read);
          if (read.running) timer = window.setTimeout(ask, POLL_MS);
        },
        () => undefined,
      );
    void ask();
    return () => {
      wanted = false;
      window.clearTimeout(timer);
    };
  }, [id, polls]);
  const begin = async () => {
    const begun = await makeStudy(id);
    if (begun) setState(begun);
    setPolls((count) => count + 1);
  };
  return { state: state, begin };
}

type Row = StudyFile["rows"][number];
type Field = "rms_um" | "angle_arcsec" | "z_error_um" | "radius_error_um" | "centre_error_um";
interface Measure {
  field: Field;
  title: PlainId;
  unit: string;
  both: boolean;
}

const MEASURES: Record<StudyFile["shape"], [Measure, Measure]> = {
  plane: [
    { field: "angle_arcsec", title: "ui-angle-between-the-normals", unit: "″", both: false },
    { field: "z_error_um", title: "ui-z-error-in-the-clouds-middle", unit: "µm", both: true },
  ],
  sphere: [
    { field: "radius_error_um", title: "ui-radius-error", unit: "µm", both: true },
    { field: "centre_error_um", title: "ui-distance-between-the-centres", unit: "µm", both: false },
  ],
};

function Charts({ study, newer, begin }: { study: StudyFile; newer: boolean; begin: () => Promise<void> }) {
  const many = study.calibrations.length;
  const colour = (i: number) => rampColour(many > 1 ? i / (many - 1) : 0);
  const measures = MEASURES[study.shape];
  const lines = (measure: Measure) =>
    study.calibrations.map((name, c) => ({
      name,
      colour: colour(c),
      values: study.rows
        .filter((row) => row.calibration === c)
        .sort((a, b) => a.cloud - b.cloud)
        .map((row) => row[measure.field] ?? 0),
    }));
  const labels = study.clouds.map((_, i) => String(i + 1));
  const against = study.against_probe ? t("ui-against-the-touched-gauge") : t("ui-against-the-mean-of-all");
  return (
    <>
      <div className={styles.again}>
        <CopyCsv tables={tables(study, measures)} />
        {newer && <PressButton onPress={begin}>{t("ui-also-rebuild-with-the-newer-ones")}</PressButton>}
      </div>
      <ul className={styles.legend}>
        {study.calibrations.map((name, c) => (
          <li key={name}>
            <span className={styles.swatch} style={{ background: colour(c) }} />
            {name}
          </li>
        ))}
      </ul>
      <div className={styles.charts}>
        {measures.map((measure) => (
          <LinesChart
            key={measure.title}
            title={`${t(measure.title)}, ${against}`}
            unit={measure.unit}
            lines={lines(measure)}
            labels={labels}
            both={measure.both}
          />
        ))}
        {study.between_clouds.length > 0 &&
          measures.map((measure, k) => (
            <RangeBars
              key={measure.title}
              title={t("ui-range-over-the-clouds", { figure: t(measure.title) })}
              unit={measure.unit}
              bars={study.between_clouds.map((range) => ({
                name: study.calibrations[range.of] ?? "",
                value: k ? range.second : range.first,
                colour: colour(range.of),
              }))}
            />
          ))}
        {study.between_calibrations.length > 0 &&
          measures.map((measure, k) => (
            <RangeBars
              key={measure.title}
              title={t("ui-range-over-the-calibrations", { figure: t(measure.title) })}
              unit={measure.unit}
              bars={study.between_calibrations.map((range) => ({
                name: study.clouds[range.of] ?? "",
                value: k ? range.second : range.first,
                colour: "var(--ink-3)",
              }))}
            />
          ))}
      </div>
      {study.left_out.length > 0 && (
        <p className={styles.note}>
          {t("ui-left-out-sentence")} {study.left_out.join(" ")}
        </p>
      )}
    </>
  );
}

/** Beside each figure stands its uncertainty, which older studies do not state. */
function tables(study: StudyFile, measures: [Measure, Measure]): TableData[] {
  const figures: Omit<Measure, "both">[] = [...measures, { field: "rms_um", title: "ui-rms", unit: "µm" }];
  const uncertainty = (row: Row, { field, unit }: Omit<Measure, "both">) => {
    const value = row.expanded_uncertainty[field];
    return value === undefined ? "" : uncertaintyQuantity(value, unit);
  };
  return [
    {
      title: "ui-clouds-and-calibrations",
      head: [
        "ui-calibration",
        "ui-cloud",
        ...figures.flatMap(({ title, unit }): Head[] => [
          { title, unit },
          { title: "ui-u-k-2", unit },
        ]),
      ],
      rows: study.rows.map((row) => [
        study.calibrations[row.calibration] ?? "",
        study.clouds[row.cloud] ?? "",
        ...figures.flatMap((figure) => [quantity(row[figure.field] ?? 0, figure.unit, 2), uncertainty(row, figure)]),
      ]),
    },
  ];
}
