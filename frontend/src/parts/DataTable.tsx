import { t } from "../state/language";
import styles from "./DataTable.module.css";
import { displayedCell, displayedHead, fileHead, type TableData } from "./table";

/** A plain table of figures: the first column names, the others are numbers. */
export function DataTable({ table }: { table: TableData }) {
  return (
    <table className={styles.table}>
      <caption className={styles.caption}>{t(table.title)}</caption>
      <thead>
        <tr>
          {table.head.map((head) => (
            <th key={fileHead(head)} scope="col">
              {displayedHead(head)}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {table.rows.map((row, i) => (
          <tr key={i}>
            {row.map((cell, k) => (
              <td key={k}>{displayedCell(cell)}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
