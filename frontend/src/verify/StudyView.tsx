import { useEffect, useState } from "react";

import { get } from "../api/http";
import { makeStudy } from "../api/verifyCommands";
import type { StudyFile } from "../api/verifyFiles";
import type { StudyState } from "../api/verifyTypes";
import { rampColour } from "../object/residuals";
import { CopyCsv } from "../parts/CopyCsv";
import { PressButton } from "../parts/PressButton";
import { Busy } from "../parts/Progress";
import { amount, type TableData } from "../parts/table";
import { counted, said, t, words } from "../state/language";
import styles from "./Charts.module.css";
import { LinesChart, RangeBars } from "./LinesChart";

const ASKED_EVERY_MS = 400;

/** The paper's test: the clouds of one verification, each rebuilt with every calibration. */
export function StudyView({ id }: { id: string }) {
  const { state, begin } = useStudy(id);
  if (!state) return null;
  if (state.running) return <div className={styles.begin}><Busy text={state.text || t("Rebuilding the clouds")} fraction={state.fraction} /></div>;
  const { study } = state;
  if (!study) {
    return (
      <div className={styles.begin}>
        <h2>{t("The same clouds with every calibration")}</h2>
        <p>
          {t(
            "Every cloud of this verification is rebuilt with each of the {n} accepted calibrations. What differs from one calibration to the next is the calibrations'; what differs from cloud to cloud is the arm's and the scanning's. It runs in the background.",
            { n: state.accepted },
          )}
        </p>
        <PressButton kind="primary" onPress={begin}>
          {counted(state.accepted, "Rebuild with the calibration", "Rebuild with {n} calibrations")}
        </PressButton>
      </div>
    );
  }
  return <Charts study={study} newer={state.accepted > study.calibrations.length + study.left_out.length} begin={begin} />;
}

function useStudy(id: string) {
  const [state, setState] = useState<StudyState | null>(null);
  const [asked, setAsked] = useState(0);
  useEffect(() => {
    let timer = 0;
    let wanted = true;
    const ask = () =>
      get<StudyState>(`/api/verifications/${id}/study`).then(
        (read) => {
          if (!wanted) return;
          setState(read);
          if (read.running) timer = window.setTimeout(ask, ASKED_EVERY_MS);
        },
        () => undefined,
      );
    void ask();
    return () => {
      wanted = false;
      window.clearTimeout(timer);
    };
  }, [id, asked]);
  const begin = async () => {
    const begun = await makeStudy(id);
    if (begun) setState(begun);
    setAsked((count) => count + 1);
  };
  return { state: state, begin };
}

type Row = StudyFile["rows"][number];
interface Measure {
  of: (row: Row) => number;
  title: string;
  unit: string;
  both: boolean;
}

const MEASURES: Record<StudyFile["shape"], [Measure, Measure]> = {
  plane: [
    { of: (row) => row.angle_arcsec ?? 0, title: words("Angle between the normals"), unit: "″", both: false },
    { of: (row) => row.z_error_um ?? 0, title: words("Z error in the cloud's middle"), unit: "µm", both: true },
  ],
  sphere: [
    { of: (row) => row.radius_error_um ?? 0, title: words("Radius error"), unit: "µm", both: true },
    { of: (row) => row.centre_error_um ?? 0, title: words("Distance between the centres"), unit: "µm", both: false },
  ],
};

function Charts({ study, newer, begin }: { study: StudyFile; newer: boolean; begin: () => Promise<void> }) {
  const many = study.calibrations.length;
  const colour = (i: number) => rampColour(many > 1 ? i / (many - 1) : 0);
  const measures = MEASURES[study.shape];
  const lines = (measure: Measure) =>
    study.calibrations.map((name, c) => ({
      name: said(name),
      colour: colour(c),
      values: study.rows.filter((row) => row.calibration === c).sort((a, b) => a.cloud - b.cloud).map(measure.of),
    }));
  const labels = study.clouds.map((name) => name.replace("Cloud ", ""));
  const against = study.against_probe ? t("against the touched gauge") : t("against the mean of all");
  return (
    <>
      <div className={styles.again}>
        <CopyCsv tables={tables(study, measures)} />
        {newer && <PressButton onPress={begin}>{t("Rebuild with the newer ones too")}</PressButton>}
      </div>
      <ul className={styles.legend}>
        {study.calibrations.map((name, c) => (
          <li key={name}>
            <span className={styles.swatch} style={{ background: colour(c) }} />
            {said(name)}
          </li>
        ))}
      </ul>
      <div className={styles.charts}>
        {measures.map((measure) => (
          <LinesChart key={measure.title} title={`${t(measure.title)}, ${against}`} unit={measure.unit} lines={lines(measure)} labels={labels} both={measure.both} />
        ))}
        {study.between_clouds.length > 0 &&
          measures.map((measure, k) => (
            <RangeBars
              key={measure.title}
              title={t("{figure}: range over the clouds", { figure: t(measure.title) })}
              unit={measure.unit}
              bars={study.between_clouds.map((range) => ({ name: said(study.calibrations[range.of] ?? ""), value: k ? range.second : range.first, colour: colour(range.of) }))}
            />
          ))}
        {study.between_calibrations.length > 0 &&
          measures.map((measure, k) => (
            <RangeBars
              key={measure.title}
              title={t("{figure}: range over the calibrations", { figure: t(measure.title) })}
              unit={measure.unit}
              bars={study.between_calibrations.map((range) => ({ name: said(study.clouds[range.of] ?? ""), value: k ? range.second : range.first, colour: "var(--ink-3)" }))}
            />
          ))}
      </div>
      {study.left_out.length > 0 && <p className={styles.note}>{t("Left out:")} {study.left_out.map(said).join(" ")}</p>}
    </>
  );
}

function tables(study: StudyFile, measures: [Measure, Measure]): TableData[] {
  return [
    {
      title: words("Clouds and calibrations"),
      head: [words("Calibration"), words("Cloud"), ...measures.map(({ title, unit }) => ({ words: title, unit })), { words: words("rms"), unit: "µm" }],
      rows: study.rows.map((row) => [
        study.calibrations[row.calibration] ?? "",
        study.clouds[row.cloud] ?? "",
        ...measures.map((measure) => amount(measure.of(row), 2, measure.unit)),
        amount(row.rms_um, 2, "µm"),
      ]),
    },
  ];
}
