import { SegmentedControl } from "@mantine/core";
import { useState } from "react";

import type { ArmResult, ParameterLine } from "../api/armTypes";
import { CopyCsv } from "../parts/CopyCsv";
import { DataTable } from "../parts/DataTable";
import { bound, plural } from "../parts/format";
import { measured } from "../parts/lengths";
import { amount, type TableData } from "../parts/table";
import styles from "./ResultView.module.css";

const TABS = [
  { value: "picture", label: "Before and after" },
  { value: "numbers", label: "Parameters" },
];

/** What the identification is worth, as bars; the parameters are one tap away. */
export function ResultView({ result }: { result: ArmResult }) {
  const [tab, setTab] = useState("picture");
  return (
    <div className={styles.result}>
      <div className={styles.tabs}>
        <SegmentedControl value={tab} onChange={setTab} data={TABS} size="md" radius="md" aria-label="What to look at" />
      </div>
      {tab === "picture" ? <BeforeAndAfter result={result} /> : <Parameters parameters={result.parameters} />}
    </div>
  );
}

function BeforeAndAfter({ result }: { result: ArmResult }) {
  const title = result.size_known ? "Tip over the whole reach" : "Tip over the whole reach, apart from the arm's size";
  const reach = { title, before_um: result.volume_before_um, after_um: result.volume_after_um };
  const held = `On ${plural(result.places, "place")} held out of the fit in turn: `;
  return (
    <div className={styles.pairs}>
      <Pair {...reach} note="Before: difference from the arm as identified. After: standard uncertainty, k = 1. Both rms." />
      {result.lines.map((line) => (
        <Pair key={line.title} {...line} note={`${held}rms, the encoders' noise included.`} />
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
        { word: "before", value: before_um },
        { word: "after", value: after_um },
      ].map(({ word, value }) => (
        <div key={word} className={styles.row} data-after={word === "after" || undefined}>
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

function Parameters({ parameters }: { parameters: ParameterLine[] }) {
  const table: TableData = {
    title: "The arm's parameters that were moved, uncertainty k = 1",
    head: ["Parameter", "Before", "After", "Change", "Uncertainty", "Unit"],
    rows: parameters.map(({ name, unit, before, after, standard_uncertainty }) => {
      const decimals = unit === "mm" ? 4 : 5;
      return [
        name.replace(/_(mm|deg)$/, ""),
        amount(before, decimals, unit),
        amount(after, decimals, unit),
        amount(after - before, decimals, unit, true),
        amount(standard_uncertainty, decimals, unit),
        { unit },
      ];
    }),
  };
  return (
    <div className={styles.parameters}>
      <div className={styles.copy}>
        <CopyCsv tables={[table]} />
      </div>
      <DataTable table={table} />
    </div>
  );
}
