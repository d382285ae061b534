import styles from "./DataTable.module.css";

export interface TableData {
  title: string;
  /** Column heads, each with its unit. */
  head: string[];
  rows: string[][];
  /** Takes the whole width where others stand side by side. */
  wide?: boolean;
}

/** A plain table of figures: the first column names, the others are numbers. */
export function DataTable({ table }: { table: TableData }) {
  return (
    <table className={styles.table}>
      <caption className={styles.caption}>{table.title}</caption>
      <thead>
        <tr>
          {table.head.map((cell) => (
            <th key={cell} scope="col">
              {cell}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {table.rows.map((row) => (
          <tr key={row.join()}>
            {row.map((cell, i) => (
              <td key={table.head[i] ?? i}>{cell}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
