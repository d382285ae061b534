import type { CalibrationResult, PosePicture } from "../api/resultTypes";
import { CopyCsv } from "../parts/CopyCsv";
import { DataTable } from "../parts/DataTable";
import { asSent } from "../state/spoken";
import styles from "./Numbers.module.css";
import { PosesTable } from "./PosesTable";
import { POSES, tablesOf } from "./tables";

export function Numbers({ result, poses }: { result: CalibrationResult; poses: PosePicture[] }) {
  const tables = tablesOf(result);
  return (
    <div className={styles.numbers}>
      <div className={styles.copy}>
        <CopyCsv tables={tablesOf(asSent(result))} />
      </div>
      <div className={styles.tables}>
        {tables.map((table) => (
          <div key={table.title} className={styles.table} data-wide={table.wide || undefined}>
            {table.title === POSES ? <PosesTable poses={poses} /> : <DataTable table={table} />}
          </div>
        ))}
      </div>
    </div>
  );
}
