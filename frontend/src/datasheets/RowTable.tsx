import type { ClipboardEvent } from "react";
import lists from "../controls/List.module.css";
import { unitOf } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { t } from "../state/language";
import styles from "./Datasheets.module.css";
import { Entry } from "./FieldInput";
import { type FormField, rowCount, rowFields, rowName, type Table, type Values } from "./forms";

interface RowTableProps {
  table: Table;
  values: Values;
  rangeOf: (field: FormField) => string;
  problemOf: (key: string) => string;
  onValues: (values: Values) => void;
}

/** The parts of a list, such as joints, a row for each. Cells of a spreadsheet can be pasted into it. */
export function RowTable({ table, values, rangeOf, problemOf, onValues }: RowTableProps) {
  const rows = rowCount(table, values);
  const paste = (row: number, column: number) => (event: ClipboardEvent) => {
    const cells = pasted(event.clipboardData.getData("text"));
    if (cells.length === 1 && cells[0]?.length === 1) return;
    event.preventDefault();
    onValues({ ...values, ...placed(cells, table, row, column, rows) });
  };
  const remove = () => {
    const last = `${table.key}.${rows - 1}.`;
    onValues(Object.fromEntries(Object.entries(values).filter(([key]) => !key.startsWith(last))));
  };
  return (
    <div className={styles.rows}>
      <div className={styles.scroll}>
        <table className={styles.table} aria-label={t(table.label)}>
          <thead>
            <tr>
              <th scope="col">
                <span className="visually-hidden">{t(table.rows)}</span>
              </th>
              {table.columns.map(({ key, label, unit }) => (
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
                <th scope="row">{values[`${table.key}.${row}.name`] ?? row + 1}</th>
                {rowFields(table, row).map((field, column) => (
                  <td key={field.key} data-head={headOf(field)} onPaste={paste(row, column)}>
                    <Entry
                      field={field}
                      label={t("ui-of-row", { label: t(field.label), row: rowName(table, row, values) })}
                      value={values[field.key] ?? ""}
                      range={rangeOf(field)}
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
      {problemsIn(table, values, problemOf).map((words) => (
        <p key={words} className={styles.problem} role="status">
          {words}
        </p>
      ))}
      <div className={styles.acts}>
        {rows < table.most && (
          <PressButton free onPress={() => onValues({ ...values, ...table.first(rows) })}>
            {t(table.add)}
          </PressButton>
        )}
        {rows > table.least && (
          <PressButton free kind="quiet" onPress={remove}>
            {t(table.remove)}
          </PressButton>
        )}
      </div>
      <p className={lists.detail}>{t("ui-cells-can-be-pasted")}</p>
    </div>
  );
}

/** A field's column, where the table has no row of heads. */
function headOf({ label, unit }: FormField): string {
  return unit ? `${t(label)}, ${unitOf(unit)}` : t(label);
}

/** What is wrong in the cells, each with its place: they are too small to say it beside them. */
function problemsIn(table: Table, values: Values, problemOf: RowTableProps["problemOf"]): string[] {
  return Array.from({ length: rowCount(table, values) }, (_, row) =>
    rowFields(table, row).flatMap(({ key, label }) => {
      const words = problemOf(key);
      const place = t("ui-of-row", { label: t(label), row: rowName(table, row, values) });
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
function placed(cells: string[][], table: Table, row: number, column: number, rows: number): Values {
  const found: Values = {};
  cells.slice(0, rows - row).forEach((line, i) => {
    const fields = rowFields(table, row + i);
    line.forEach((cell, j) => {
      const field = fields[column + j];
      if (field) found[field.key] = field.key.endsWith(".sign") ? (cell.includes("-") ? "-1" : "1") : cell.trim();
    });
  });
  return found;
}
