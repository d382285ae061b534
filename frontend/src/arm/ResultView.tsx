import { useState } from "react";

import type { ArmResult } from "../api/wire";
import { CopyCsv } from "../controls/CopyCsv";
import { DataTable } from "../controls/DataTable";
import { measured } from "../controls/lengths";
import { Reports } from "../controls/Reports";
import { Segments } from "../controls/Segments";
import type { TableData } from "../controls/table";
import { quantity, signedQuantity } from "../messages/text";
import { t } from "../state/language";
import styles from "./ResultView.module.css";

const TABS = [
  { value: "picture", label: "ui-before-and-after" },
  { value: "numbers", label: "ui-parameters" },
] as const;

/** The accuracy of the identification as bars; the parameters are one tap away. */
export function ResultView({ result, id }: { result: ArmResult; id: string }) {
  const [tab, setTab] = useState("picture");
  return (
    <div className={styles.result}>
      <div className={styles.tabs}>
        <Segments
          value={tab}
          onChange={setTab}
          options={TABS.map(({ value, label }) => ({ value, label: t(label) }))}
          label={t("ui-view")}
        />
        <Reports of={`/api/arm/identifications/${id}`} />
      </div>
      {tab === "picture" ? <BeforeAndAfter result={result} /> : <Parameters result={result} />}
    </div>
  );
}

function BeforeAndAfter({ result }: { result: ArmResult }) {
  const title = result.size_known ? t("ui-tip-error-over-the-whole-reach") : t("ui-tip-error-over-whole-reach-without");
  const reach = { title, before_um: result.volume_before_um, after_um: result.volume_after_um };
  const crossValidated = t("ui-cross-validated-places-left-out-fit", { n: result.places });
  return (
    <div className={styles.pairs}>
      <Pair {...reach} note={t("ui-before-difference-identified-arm-after-standard")} />
      {result.lines.map((line) => (
        <Pair key={line.title} {...line} note={crossValidated} />
      ))}
    </div>
  );
}

interface PairProps {
  title: string;
  before_um: number;
  after_um: number;
  note: string;
}

function Pair({ title, before_um, after_um, note }: PairProps) {
  const largest = Math.max(before_um, after_um, 1e-9);
  return (
    <section className={styles.pair} aria-label={title}>
      <h3 className={styles.title}>{title}</h3>
      {[
        { word: t("ui-before-lowercase"), value: before_um, after: false },
        { word: t("ui-after-lowercase"), value: after_um, after: true },
      ].map(({ word, value, after }) => (
        <div key={word} className={styles.row} data-after={after || undefined}>
          <span className={styles.word}>{word}</span>
          <span className={styles.track}>
            <span className={styles.bar} style={{ width: `${(100 * value) / largest}%` }} />
          </span>
          <span className={styles.value}>{measured(value, "µm", 1)}</span>
        </div>
      ))}
      <p className={styles.note}>{note}</p>
    </section>
  );
}

function Parameters({ result }: { result: ArmResult }) {
  const tables = [changed(result), correlated(result), unchanged(result)].filter(({ rows }) => rows.length > 0);
  return (
    <div className={styles.parameters}>
      <div className={styles.copy}>
        <CopyCsv tables={tables} />
      </div>
      {tables.map((table) => (
        <DataTable key={table.title} table={table} />
      ))}
    </div>
  );
}

function changed({ parameters }: ArmResult): TableData {
  return {
    title: "ui-changed-parameters-arm-uncertainty-k-1",
    head: ["ui-parameter", "ui-before", "ui-after", "ui-change", "ui-uncertainty", "ui-unit"],
    rows: parameters.map(({ name, unit, before, after, standard_uncertainty }) => {
      const decimals = unit === "mm" ? 4 : 5;
      return [
        short(name),
        quantity(before, unit, decimals),
        quantity(after, unit, decimals),
        signedQuantity(after - before, unit, decimals),
        quantity(standard_uncertainty, unit, decimals),
        { unit },
      ];
    }),
  };
}

/** Pairs that the places hardly separate, which is why their uncertainties exceed the tip's. */
function correlated({ correlated: pairs }: ArmResult): TableData {
  return {
    title: "ui-correlated-well-determined-together-less-well",
    head: ["ui-parameters", "ui-coefficient"],
    rows: pairs.map(({ first, second, coefficient }) => [
      `${short(first)}, ${short(second)}`,
      signedQuantity(coefficient, "", 3),
    ]),
  };
}

function unchanged({ kept: lines }: ArmResult): TableData {
  return {
    title: "ui-unchanged-parameters",
    head: ["ui-parameters", "ui-why"],
    rows: lines.map(({ names, why }) => [names.split(", ").map(short).join(", "), why]),
  };
}

function short(name: string): string {
  return name.replace(/_(mm|deg)$/, "");
}
