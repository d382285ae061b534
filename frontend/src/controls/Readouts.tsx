import type { Quality } from "../api/types";
import { QualityMark } from "./QualityMark";
import styles from "./Readouts.module.css";

export interface Readout {
  label: string;
  value: string;
  unit?: string;
  quality?: Quality;
  /** The target, or the direction to it. */
  note?: string;
}

/** A row of small labelled figures, as on an instrument panel; in several rows if there is no space
 *  for one, of equal columns with ``wrap``. */
export function Readouts({ readouts, wrap = false }: { readouts: Readout[]; wrap?: boolean }) {
  const row = (
    <dl className={styles.readouts} data-wrap={wrap || undefined}>
      {readouts.map(({ label, value, unit, quality, note }) => (
        <div key={label} className={styles.readout}>
          <dt>{label}</dt>
          <dd>
            {quality && quality !== "neutral" && <QualityMark quality={quality} size="1.125rem" />}
            {value}
            {unit && <span> {unit}</span>}
          </dd>
          {note && <dd className={styles.note}>{note}</dd>}
        </div>
      ))}
    </dl>
  );
  return wrap ? <div className={styles.wrap}>{row}</div> : row;
}
