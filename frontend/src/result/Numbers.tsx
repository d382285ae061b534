import type { ObjectGeometry } from "../api/types";
import type { CalibrationResult, PosePicture } from "../api/wire";
import { CopyCsv } from "../controls/CopyCsv";
import { DataTable } from "../controls/DataTable";
import { asSent } from "../state/localized";
import styles from "./Numbers.module.css";
import { PosesTable } from "./PosesTable";
import { POSES, tablesOf } from "./tables";

interface NumbersProps {
  result: CalibrationResult;
  poses: PosePicture[];
  object: ObjectGeometry;
}

export function Numbers({ result, poses, object }: NumbersProps) {
  const tables = tablesOf(result, object);
  return (
    <div className={styles.numbers}>
      <div className={styles.copy}>
        <CopyCsv tables={tablesOf(asSent(result), object)} />
      </div>
      <div className={styles.tables}>
        {tables.map((table) => (
          <div key={table.title} className={styles.table} data-wide={table.wide || undefined}>
            {table.title === POSES ? <PosesTable poses={poses} object={object} /> : <DataTable table={table} />}
          </div>
        ))}
      </div>
    </div>
  );
}
