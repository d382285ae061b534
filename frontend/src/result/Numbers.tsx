import type { CalibrationResult } from "../api/types";
import { CopyCsv } from "../parts/CopyCsv";
import { DataTable } from "../parts/DataTable";
import styles from "./Numbers.module.css";
import { tablesOf } from "./tables";

export function Numbers({ result }: { result: CalibrationResult }) {
  const tables = tablesOf(result);
  return (
    <div className={styles.numbers}>
      <div className={styles.copy}>
        <CopyCsv tables={tables} />
      </div>
      <div className={styles.tables}>
        {tables.map((table) => (
          <div key={table.title} className={styles.table} data-wide={table.wide || undefined}>
            <DataTable table={table} />
          </div>
        ))}
      </div>
    </div>
  );
}
