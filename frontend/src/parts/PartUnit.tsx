import type { KeptPartView, ScanSize } from "../api/wire";
import fields from "../controls/Field.module.css";
import { lengthFigures, unitOf } from "../controls/lengths";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { useRead } from "../state/useRead";
import styles from "./ComparePanel.module.css";

export type Unit = "mm" | "cm" | "m" | "inch";

const MM_PER: Record<Unit, number> = { mm: 1, cm: 10, m: 1000, inch: 25.4 };

interface PartUnitProps {
  part: KeptPartView;
  scan: string;
  unit: Unit | "";
  onChange: (unit: Unit) => void;
}

/** Asks for the unit of a file that states none: each with the size that the part then has. */
export function PartUnit({ part, scan, unit, onChange }: PartUnitProps) {
  const loaded = useLive((s) => s.view?.scans.find(({ id }) => id === scan)?.loaded ?? 0);
  const { value: extents } = useRead<ScanSize>(`/api/scans/${encodeURIComponent(scan)}/size`, `${loaded === 1}`);
  return (
    <fieldset className={styles.units}>
      <legend className={fields.label}>{t("ui-the-file-states-no-unit")}</legend>
      {extents?.mm && <p className={styles.note}>{t("ui-the-scan-is-of-size", { size: sizeText(extents.mm) })}</p>}
      {(Object.keys(MM_PER) as Unit[]).map((one) => (
        <label key={one} className={styles.unit} data-chosen={one === unit || undefined}>
          <input type="radio" name="part-unit" checked={one === unit} onChange={() => onChange(one)} />
          <span className={styles.unitName}>{one}</span>
          <span className={styles.unitSize}>{sizeText(part.size.map((side) => side * MM_PER[one]))}</span>
        </label>
      ))}
    </fieldset>
  );
}

/** The largest side first, as the scan has them in any order. */
function sizeText(sides_mm: readonly number[]): string {
  const sorted = [...sides_mm].sort((a, b) => b - a);
  const most = sorted[0] ?? 0;
  const written = sorted.map((side) => lengthFigures(side, "mm", most >= 100 ? 0 : 1));
  return `${written.join(" × ")} ${unitOf("mm")}`;
}
