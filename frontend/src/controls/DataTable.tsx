import { t } from "../state/language";
import styles from "./DataTable.module.css";
import { displayedCell, displayedHead, fileHead, type TableData } from "./table";

/** From so many columns on, a table needs a wide place. */
const WIDE_COLUMNS = 7;

/** A plain table of figures: the first column names, the others are numbers. Where it is wider than
 *  its place, each row becomes a list of its cells. */
export function DataTable({ table }: { table: TableData }) {
  return (
    <div className={styles.place}>
      <Rows table={table} />
    </div>
  );
}

function Rows({ table }: { table: TableData }) {
  return (
    <table className={styles.table} data-wide={table.head.length >= WIDE_COLUMNS || undefined}>
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
              <td key={k} data-head={table.head[k] && displayedHead(table.head[k])}>
                {displayedCell(cell)}
              </td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
