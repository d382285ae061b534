import { useState } from "react";

import type { ArmResult } from "../api/armTypes";
import { CopyCsv } from "../parts/CopyCsv";
import { DataTable } from "../parts/DataTable";
import { Reports } from "../parts/Reports";
import { Segments } from "../parts/Segments";
import { bound } from "../parts/format";
import { measured } from "../parts/lengths";
import { amount, type TableData } from "../parts/table";
import { counted, t, words } from "../state/language";
import styles from "./ResultView.module.css";

const TABS = [
  { value: "picture", label: words("Before and after") },
  { value: "numbers", label: words("Parameters") },
];

/** What the identification is worth, as bars; the parameters are one tap away. */
export function ResultView({ result, id }: { result: ArmResult; id: string }) {
  const [tab, setTab] = useState("picture");
  return (
    <div className={styles.result}>
      <div className={styles.tabs}>
        <Segments value={tab} onChange={setTab} options={TABS.map(({ value, label }) => ({ value, label: t(label) }))} label={t("What to look at")} />
        <Reports of={`/api/arm/identifications/${id}`} />
      </div>
      {tab === "picture" ? <BeforeAndAfter result={result} /> : <Parameters result={result} />}
    </div>
  );
}

function BeforeAndAfter({ result }: { result: ArmResult }) {
  const title = result.size_known ? t("Tip over the whole reach") : t("Tip over the whole reach, apart from the arm's size");
  const reach = { title, before_um: result.volume_before_um, after_um: result.volume_after_um };
  const held = counted(
    result.places,
    "On {n} place held out of the fit in turn: rms, the encoders' noise included.",
    "On {n} places held out of the fit in turn: rms, the encoders' noise included.",
  );
  return (
    <div className={styles.pairs}>
      <Pair {...reach} note={t("Before: difference from the arm as identified. After: standard uncertainty, k = 1. Both rms.")} />
      {result.lines.map((line) => (
        <Pair key={line.title} {...line} note={held} />
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
        { word: t("before"), value: before_um, after: false },
        { word: t("after"), value: after_um, after: true },
      ].map(({ word, value, after }) => (
        <div key={word} className={styles.row} data-after={after || undefined}>
          <span className={styles.word}>{word}</span>
          <span className={styles.track}>
            <span className={styles.bar} style={{ width: `${(100 * value) / largest}%` }} />
          </span>
          <span className={styles.value}>{measured(value, "µm", 1)}</span>
        </div>
      ))}
      <p className={styles.note}>{bound(note)}</p>
    </section>
  );
}

function Parameters({ result }: { result: ArmResult }) {
  const tables = [moved(result), correlated(result), kept(result)].filter(({ rows }) => rows.length > 0);
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

function moved({ parameters }: ArmResult): TableData {
  return {
    title: words("The arm's parameters that were moved, uncertainty k = 1"),
    head: [words("Parameter"), words("Before"), words("After"), words("Change"), words("Uncertainty"), words("Unit")],
    rows: parameters.map(({ name, unit, before, after, standard_uncertainty }) => {
      const decimals = unit === "mm" ? 4 : 5;
      return [
        short(name),
        amount(before, decimals, unit),
        amount(after, decimals, unit),
        amount(after - before, decimals, unit, true),
        amount(standard_uncertainty, decimals, unit),
        { unit },
      ];
    }),
  };
}

/** Pairs that the places hardly tell apart: why their uncertainties are larger than the tip's. */
function correlated({ correlated: pairs }: ArmResult): TableData {
  return {
    title: words("Correlated: told together, each alone less well"),
    head: [words("Parameters"), words("Coefficient")],
    rows: pairs.map(({ first, second, coefficient }) => [`${short(first)}, ${short(second)}`, amount(coefficient, 3, "", true)]),
  };
}

function kept({ kept: lines }: ArmResult): TableData {
  return {
    title: words("Parameters that kept their values"),
    head: [words("Parameters"), words("Why")],
    rows: lines.map(({ names, why }) => [names.split(", ").map(short).join(", "), why]),
  };
}

function short(name: string): string {
  return name.replace(/_(mm|deg)$/, "");
}
