import { SegmentedControl } from "@mantine/core";
import { useState } from "react";

import { CopyCsv } from "../parts/CopyCsv";
import { DataTable } from "../parts/DataTable";
import frame from "../result/ResultPicture.module.css";
import { DeviationMap } from "./DeviationMap";
import { FigureBars } from "./FigureBars";
import { OverClouds } from "./OverClouds";
import styles from "./ResultTabs.module.css";
import { type Shown, tablesOf } from "./shown";
import { StudyView } from "./StudyView";

/** Pictures first: what the clouds show, and over clouds and calibrations; the table one tap away. */
export function ResultTabs({ shown, id }: { shown: Shown; id?: string }) {
  const [tab, setTab] = useState("figures");
  const tabs = [
    { value: "figures", label: "Figures" },
    { value: "map", label: "Map" },
    { value: "clouds", label: "Clouds" },
    ...(id ? [{ value: "study", label: "Calibrations" }] : []),
    { value: "numbers", label: "Numbers" },
  ];
  return (
    <div className={frame.picture}>
      <div className={frame.tabs}>
        <SegmentedControl
          value={tab}
          onChange={setTab}
          data={tabs}
          size="md"
          radius="md"
          aria-label="What to look at"
          classNames={{ root: frame.control ?? "", label: frame.tab ?? "", indicator: frame.indicator ?? "" }}
        />
      </div>
      <div className={frame.shown}>
        {tab === "figures" && <FigureBars found={shown.figures} />}
        {tab === "map" && <DeviationMap clouds={shown.clouds} shape={shown.shape} />}
        {tab === "clouds" && <OverClouds shown={shown} />}
        {tab === "study" && id && <StudyView id={id} />}
        {tab === "numbers" && <Tables shown={shown} />}
      </div>
    </div>
  );
}

function Tables({ shown }: { shown: Shown }) {
  const tables = tablesOf(shown);
  return (
    <div className={styles.tables}>
      <div className={styles.copy}>
        <CopyCsv tables={tables} />
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
