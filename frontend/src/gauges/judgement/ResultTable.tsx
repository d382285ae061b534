import type { ReactNode } from "react";

import type { PerformanceFigureLine, PerformanceResultView } from "../../api/wire";
import { measured, signedLength } from "../../controls/lengths";
import { decimalsBeside, limitBeside } from "../../controls/limits";
import { QualityMark } from "../../controls/QualityMark";
import { uncertaintyQuantity } from "../../controls/uncertainty";
import { render, t } from "../../state/language";
import { DECISIONS, QUALITY } from "../quick/verification";
import styles from "./ResultTable.module.css";

interface ResultTableProps {
  result: Pick<PerformanceResultView, "figures" | "offset" | "status" | "problems" | "notes">;
  /** What is drawn of it, below the figures. */
  children?: ReactNode;
}

/** Every symbol in words with its value, its limit and the decision; what else should be known. */
export function ResultTable({ result, children }: ResultTableProps) {
  return (
    <div className={styles.result}>
      {result.status && <p className={styles.status}>{result.status}</p>}
      {result.problems.map((text) => (
        <p key={text} className={styles.problem}>
          {text}
        </p>
      ))}
      <table className={styles.table}>
        <thead>
          <tr>
            <th scope="col">{t("ui-figure")}</th>
            <th scope="col">{t("ui-value")}</th>
            <th scope="col">{t("ui-limit")}</th>
            <th scope="col">{t("ui-decision")}</th>
          </tr>
        </thead>
        <tbody>
          {result.figures.map((figure) => (
            <Row key={figure.quantity} figure={figure} />
          ))}
        </tbody>
      </table>
      {children}
      {result.offset && (
        <section className={styles.section}>
          <h3>{t("ui-implied-probe-matrix-error")}</h3>
          <p>{result.offset}</p>
        </section>
      )}
      {result.notes.map((note) => (
        <p key={note} className={styles.note}>
          {note}
        </p>
      ))}
    </div>
  );
}

function Row({ figure }: { figure: PerformanceFigureLine }) {
  const signed = /^(size|length|effective)/.test(figure.quantity);
  const { value, limit, test_uncertainty } = figure;
  return (
    <tr data-quantity={figure.quantity}>
      <th scope="row">
        <span className={styles.title}>{figure.title}</span>
        <span className={styles.symbol}>{figure.symbol}</span>
        {figure.problem && <span className={styles.problem}>{figure.problem}</span>}
      </th>
      <td>
        {value === null ? "–" : (signed ? signedLength : measured)(value, "µm", decimalsBeside(value, limit, 1))}
        {value !== null && test_uncertainty !== null && (
          <span className={styles.symbol}>U = {render(uncertaintyQuantity(test_uncertainty, "µm"))}</span>
        )}
      </td>
      <td>{limit === null ? "–" : `${signed ? "± " : ""}${render(limitBeside(limit, "µm", 1, value))}`}</td>
      <td>
        <span className={styles.decision}>
          <QualityMark quality={QUALITY[figure.decision]} size="1.25rem" />
          {t(DECISIONS[figure.decision])}
        </span>
      </td>
    </tr>
  );
}
