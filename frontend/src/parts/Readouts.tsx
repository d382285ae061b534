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

/** A row of small labelled figures, as on an instrument panel; in several rows (``wrap``)
 *  if there is no space for six. */
export function Readouts({ readouts, wrap = false }: { readouts: Readout[]; wrap?: boolean }) {
  const row = (
    // one row may be wider than its space, and also scrolls with the keyboard
    <dl className={styles.readouts} data-wrap={wrap || undefined} tabIndex={wrap ? undefined : 0}>
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
