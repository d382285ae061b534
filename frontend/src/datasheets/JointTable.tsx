import type { ClipboardEvent } from "react";

import { unitOf } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { t } from "../state/language";
import styles from "./Datasheets.module.css";
import { Entry } from "./FieldInput";
import { firstJoint, JOINT, jointCount, jointFields, LEAST_JOINTS, MOST_JOINTS, type Values } from "./forms";

interface JointTableProps {
  values: Values;
  problemOf: (key: string) => string;
  onValues: (values: Values) => void;
}

/** The Denavit-Hartenberg table: a row for each joint. Cells of a spreadsheet can be pasted into it. */
export function JointTable({ values, problemOf, onValues }: JointTableProps) {
  const rows = jointCount(values);
  const paste = (row: number, column: number) => (event: ClipboardEvent) => {
    const cells = pasted(event.clipboardData.getData("text"));
    if (cells.length === 1 && cells[0]?.length === 1) return;
    event.preventDefault();
    onValues({ ...values, ...placed(cells, row, column, rows) });
  };
  const remove = () => {
    const last = `joints.${rows - 1}.`;
    onValues(Object.fromEntries(Object.entries(values).filter(([key]) => !key.startsWith(last))));
  };
  return (
    <div className={styles.joints}>
      <div className={styles.scroll}>
        <table className={styles.table} aria-label={t("ui-denavit-hartenberg-table")}>
          <thead>
            <tr>
              <th scope="col">{t("ui-joint-column")}</th>
              {JOINT.map(({ key, label, unit }) => (
                <th key={key} scope="col">
                  {t(label)}
                  {unit && <span>{unitOf(unit)}</span>}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {Array.from({ length: rows }, (_, row) => (
              <tr key={row}>
                <th scope="row">{values[`joints.${row}.name`]}</th>
                {jointFields(row).map((field, column) => (
                  <td key={field.key} onPaste={paste(row, column)}>
                    <Entry
                      field={field}
                      label={t("ui-of-joint", { label: t(field.label), joint: values[`joints.${row}.name`] ?? "" })}
                      value={values[field.key] ?? ""}
                      problem={problemOf(field.key)}
                      onText={(text) => onValues({ ...values, [field.key]: text })}
                    />
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      {problemsIn(rows, values, problemOf).map((words) => (
        <p key={words} className={styles.problem} role="status">
          {words}
        </p>
      ))}
      <div className={styles.acts}>
        {rows < MOST_JOINTS && (
          <PressButton free onPress={() => onValues({ ...values, ...firstJoint(rows) })}>
            {t("ui-add-a-joint")}
          </PressButton>
        )}
        {rows > LEAST_JOINTS && (
          <PressButton free kind="quiet" onPress={remove}>
            {t("ui-remove-the-last-joint")}
          </PressButton>
        )}
      </div>
      <p className={styles.note}>{t("ui-cells-can-be-pasted")}</p>
    </div>
  );
}

/** What is wrong in the cells, each with its place: they are too small to say it beside them. */
function problemsIn(rows: number, values: Values, problemOf: JointTableProps["problemOf"]): string[] {
  return Array.from({ length: rows }, (_, row) =>
    jointFields(row).flatMap(({ key, label }) => {
      const words = problemOf(key);
      const place = t("ui-of-joint", { label: t(label), joint: values[`joints.${row}.name`] ?? "" });
      return words ? [t("ui-place-and-problem", { place, words })] : [];
    }),
  ).flat();
}

/** The cells of copied text: columns by tabs or semicolons, else by spaces. */
function pasted(text: string): string[][] {
  const lines = text.trim().split(/\r?\n/);
  const by = /[\t;]/.test(text) ? /[\t;]/ : /\s+/;
  return lines.map((line) => line.trim().split(by));
}

/** The cells from a place of the table on; what is beyond it is left out. */
function placed(cells: string[][], row: number, column: number, rows: number): Values {
  const found: Values = {};
  cells.slice(0, rows - row).forEach((line, i) => {
    const fields = jointFields(row + i);
    line.forEach((cell, j) => {
      const field = fields[column + j];
      if (field) found[field.key] = field.key.endsWith(".sign") ? (cell.includes("-") ? "-1" : "1") : cell.trim();
    });
  });
  return found;
}
