import type { Legend } from "../api/wire";
import type { PlainId } from "../messages/text";
import { figures } from "../parts/format";
import { inUnit, unitOf } from "../parts/lengths";
import { t } from "../state/language";
import styles from "./LegendBar.module.css";

export const MEASURES: Record<Legend["measure"], { name: PlainId; legend: PlainId }> = {
  height: { name: "ui-height", legend: "ui-height" },
  intensity: { name: "ui-returned-light", legend: "ui-returned-light" },
  uncertainty: { name: "ui-uncertainty", legend: "ui-uncertainty-of-a-point-k-1" },
  age: { name: "ui-age", legend: "ui-age-relative-to-the-newest-point" },
  deviation: { name: "ui-deviation", legend: "ui-deviation-from-the-shape" },
};

/** As many decimals as necessary for the ends to differ. */
export function decimalsOf({ low, high }: { low: number; high: number }): number {
  const span = Math.abs(high - low);
  if (span >= 100 || span === 0) return 0;
  return span >= 10 ? 1 : span >= 1 ? 2 : 3;
}

/** The legend's ends in the displayed unit. */
export function inDisplayedUnit({ low, high, unit }: Legend): { low: number; high: number; unit: string } {
  return { low: inUnit(low, unit), high: inUnit(high, unit), unit: unitOf(unit) };
}

/** Legend of the colours: a bar with its ends and its middle. */
export function LegendBar({ legend }: { legend: Legend }) {
  const { unit, low, high } = inDisplayedUnit(legend);
  const decimals = decimalsOf({ low, high });
  return (
    <figure className={styles.legend}>
      <figcaption className={styles.title}>
        {t(MEASURES[legend.measure].legend)}
        <span className={styles.unit}>{unit}</span>
      </figcaption>
      <div className={styles.bar} style={{ background: `linear-gradient(to right, ${legend.colours.join(", ")})` }} />
      <div className={styles.ends}>
        {[low, (low + high) / 2, high].map((value, i) => (
          <span key={i}>{figures(value, decimals)}</span>
        ))}
      </div>
    </figure>
  );
}
