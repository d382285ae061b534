import type { Legend } from "../api/viewTypes";
import { figures } from "../parts/format";
import { inUnit, unitOf } from "../parts/lengths";
import { said, t, words } from "../state/language";
import styles from "./LegendBar.module.css";

export const MEASURES: Record<Legend["measure"], { name: string; legend: string }> = {
  height: { name: words("Height"), legend: words("Height") },
  intensity: { name: words("Light returned"), legend: words("Light returned") },
  uncertainty: { name: words("Uncertainty"), legend: words("Uncertainty of a point, k = 1") },
  age: { name: words("Age"), legend: words("Age, before the newest") },
  deviation: { name: words("Deviation"), legend: words("Deviation from the shape") },
};

/** So many decimals that the ends can be told apart. */
export function decimalsOf({ low, high }: { low: number; high: number }): number {
  const span = Math.abs(high - low);
  if (span >= 100 || span === 0) return 0;
  return span >= 10 ? 1 : span >= 1 ? 2 : 3;
}

/** The legend's ends in the unit that is shown. */
export function inShown({ low, high, unit }: Legend): { low: number; high: number; unit: string } {
  return { low: inUnit(low, unit), high: inUnit(high, unit), unit: unitOf(unit) };
}

/** What the colours mean: a bar with its ends and its middle. */
export function LegendBar({ legend }: { legend: Legend }) {
  const { unit, low, high } = inShown(legend);
  const decimals = decimalsOf({ low, high });
  return (
    <figure className={styles.legend}>
      <figcaption className={styles.title}>
        {t(MEASURES[legend.measure].legend)}
        <span className={styles.unit}>{said(unit)}</span>
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
