import { useId, useState } from "react";

import type { PerformanceSymbols } from "../../api/wire";
import look from "../../controls/Control.module.css";
import { moment } from "../../controls/format";
import { measured, signedLength } from "../../controls/lengths";
import { TimeChart } from "../../controls/TimeChart";
import styles from "../../records/History.module.css";
import { t } from "../../state/language";
import { go } from "../../state/router";
import { useList } from "../../state/useList";
import { DECISIONS, QUALITY } from "../quick/verification";
import { listSeries, type Point } from "./performanceSeries";

/**
 * One symbol of the performance tests over time: of the tests with the arm of the newest one, and on
 * the same kind of artefact. Each limit is that of its own test.
 */
export function PerformanceHistory({ change }: { change: string }) {
  const { list } = useList<PerformanceSymbols>("/api/performance-history", change);
  const [selected, setSelected] = useState("");
  const id = useId();
  if (!list?.length) return null;
  const series = listSeries(list);
  const shown = series.find(({ key }) => key === selected) ?? series[0];
  if (!shown) return <p className={styles.first}>{t("ui-symbols-over-time-appear-after-second-test")}</p>;
  const { points } = shown;
  return (
    <div className={styles.history}>
      <div className={styles.choice}>
        <select
          id={id}
          className={`${look.input} ${styles.select}`}
          aria-label={t("ui-plotted-quantity")}
          value={shown.key}
          onChange={(event) => setSelected(event.target.value)}
        >
          {series.map(({ key, label }) => (
            <option key={key} value={key}>
              {label}
            </option>
          ))}
        </select>
      </div>
      <TimeChart
        points={points.map(({ id, ended_at, found }) => ({
          id,
          at: ended_at,
          value: found.value,
          limit: found.limit,
          uncertainty: found.test_uncertainty,
          quality: QUALITY[found.decision],
        }))}
        unit="µm"
        label={t("ui-over-time", { figure: shown.symbol })}
        signed={shown.signed}
        onPoint={(id) => go("performance", id)}
      />
      <p className={styles.words}>
        {t("ui-bars-test-value-uncertainty-dashed-limit-as-of-test")} {summarised(points)}
        {new Set(points.map(({ rule }) => rule)).size > 1 && ` ${t("ui-decision-rule-changed-values-comparable")}`}
      </p>
    </div>
  );
}

/** The newest value with its decision, and what changed since the first. */
function summarised(points: Point[]): string {
  const known = points.filter(({ found }) => found.value !== null);
  const [first, last] = [known[0], known[known.length - 1]];
  if (first?.found.value == null || last?.found.value == null) return "";
  const { value, signed, decision } = last.found;
  const figure = signed ? signedLength(value, "µm") : measured(value, "µm");
  const latest = t("ui-latest-decided", { value: figure, decision: t(DECISIONS[decision]) });
  if (first === last) return latest;
  const moved = signedLength(value - first.found.value, "µm");
  return `${latest} ${t("ui-since-moved-by", { date: moment(first.ended_at), change: moved })}`;
}
