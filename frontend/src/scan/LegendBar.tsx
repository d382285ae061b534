import type { Legend } from "../api/viewTypes";
import { figures } from "../parts/format";
import { inUnit, unitOf } from "../parts/lengths";
import styles from "./LegendBar.module.css";

export const MEASURES: Record<Legend["measure"], { name: string; legend: string }> = {
  height: { name: "Height", legend: "Height" },
  intensity: { name: "Light returned", legend: "Light returned" },
  uncertainty: { name: "Uncertainty", legend: "Uncertainty of a point, k = 1" },
  age: { name: "Age", legend: "Age, before the newest" },
  deviation: { name: "Deviation", legend: "Deviation from the shape" },
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
        {MEASURES[legend.measure].legend}
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
