import { t } from "../state/language";
import styles from "./DataTable.module.css";
import { bound } from "./format";
import { plainHead, shownCell, shownHead, type TableData } from "./table";

/** A plain table of figures: the first column names, the others are numbers. */
export function DataTable({ table }: { table: TableData }) {
  return (
    <table className={styles.table}>
      <caption className={styles.caption}>{t(table.title)}</caption>
      <thead>
        <tr>
          {table.head.map((head) => (
            <th key={plainHead(head)} scope="col">
              {bound(shownHead(head))}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {table.rows.map((row, i) => (
          <tr key={i}>
            {row.map((cell, k) => (
              <td key={k}>{shownCell(cell)}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
