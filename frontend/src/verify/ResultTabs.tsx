import { useState } from "react";

import { CopyCsv } from "../parts/CopyCsv";
import { DataTable } from "../parts/DataTable";
import { Segments } from "../parts/Segments";
import frame from "../result/ResultPicture.module.css";
import { t } from "../state/language";
import { DeviationMap } from "./DeviationMap";
import { FigureBars } from "./FigureBars";
import { OverClouds } from "./OverClouds";
import styles from "./ResultTabs.module.css";
import { type Shown, tablesOf } from "./shown";
import { StudyView } from "./StudyView";

interface ResultTabsProps {
  shown: Shown;
  /** The same in the station's own words, for files. */
  sent: Shown;
  id?: string;
}

/** Pictures first: what the clouds show, and over clouds and calibrations; the table one tap away. */
export function ResultTabs({ shown, sent, id }: ResultTabsProps) {
  const [tab, setTab] = useState("figures");
  const tabs = [
    { value: "figures", label: t("Figures") },
    { value: "map", label: t("Map") },
    { value: "clouds", label: t("Clouds") },
    ...(id ? [{ value: "study", label: t("Calibrations") }] : []),
    { value: "numbers", label: t("Numbers") },
  ];
  return (
    <div className={frame.picture}>
      <div className={frame.tabs}>
        <Segments
          value={tab}
          onChange={setTab}
          options={tabs}
          label={t("What to look at")}
        />
      </div>
      <div className={frame.shown} tabIndex={0}>
        {tab === "figures" && <FigureBars found={shown.figures} />}
        {tab === "map" && <DeviationMap clouds={shown.clouds} shape={shown.shape} />}
        {tab === "clouds" && <OverClouds shown={shown} />}
        {tab === "study" && id && <StudyView id={id} />}
        {tab === "numbers" && <Tables shown={shown} sent={sent} />}
      </div>
    </div>
  );
}

function Tables({ shown, sent }: Omit<ResultTabsProps, "id">) {
  const tables = tablesOf(shown);
  return (
    <div className={styles.tables}>
      <div className={styles.copy}>
        <CopyCsv tables={tablesOf(sent)} />
      </div>
      {tables.map((table) => (
        <div key={table.title} className={styles.table}>
          <DataTable table={table} />
        </div>
      ))}
      {shown.notes.map((note) => (
        <p key={note} className={styles.note}>
          {note}
        </p>
      ))}
    </div>
  );
}
