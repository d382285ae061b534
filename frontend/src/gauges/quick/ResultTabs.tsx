import { useState } from "react";

import { CopyCsv } from "../../controls/CopyCsv";
import { DataTable } from "../../controls/DataTable";
import { Segments } from "../../controls/Segments";
import frame from "../../result/ResultPicture.module.css";
import { t } from "../../state/language";
import { Declared } from "./Declared";
import { DeviationMap } from "./DeviationMap";
import { FigureBars } from "./FigureBars";
import { OverClouds } from "./OverClouds";
import styles from "./ResultTabs.module.css";
import { StudyView } from "./StudyView";
import { type DisplayedVerification, tablesOf } from "./verification";

interface ResultTabsProps {
  displayed: DisplayedVerification;
  /** The same in the station's own words, for files. */
  sent: DisplayedVerification;
  id?: string;
}

/** Pictures first: results of the clouds, over clouds and calibrations; the table one tap away. */
export function ResultTabs({ displayed, sent, id }: ResultTabsProps) {
  const [tab, setTab] = useState("figures");
  const tabs = [
    { value: "figures", label: t("ui-figures") },
    { value: "map", label: t("ui-map") },
    { value: "clouds", label: t("ui-clouds") },
    ...(id ? [{ value: "study", label: t("ui-calibrations") }] : []),
    { value: "numbers", label: t("ui-numbers") },
  ];
  return (
    <div className={frame.picture}>
      <div className={frame.tabs}>
        <Segments value={tab} onChange={setTab} options={tabs} label={t("ui-view")} />
      </div>
      <div className={frame.content} tabIndex={0}>
        {tab === "figures" && (
          <div className={styles.figures}>
            <FigureBars found={displayed.figures} />
            <Declared rule={displayed.rule} filters={null} both={statesBoth(displayed)} />
          </div>
        )}
        {tab === "map" && <DeviationMap clouds={displayed.clouds} shape={displayed.shape} />}
        {tab === "clouds" && <OverClouds verification={displayed} />}
        {tab === "study" && id && <StudyView id={id} />}
        {tab === "numbers" && <Tables displayed={displayed} sent={sent} />}
      </div>
    </div>
  );
}

function statesBoth({ figures }: DisplayedVerification): boolean {
  return figures.some((figure) => figure.test_uncertainty !== null);
}

function Tables({ displayed, sent }: Omit<ResultTabsProps, "id">) {
  const tables = tablesOf(displayed);
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
      <Declared rule={displayed.rule} filters={displayed.filters} both={statesBoth(displayed)} />
      {displayed.notes.map((note) => (
        <p key={note} className={styles.note}>
          {note}
        </p>
      ))}
    </div>
  );
}
