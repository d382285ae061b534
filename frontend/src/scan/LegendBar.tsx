import type { Legend } from "../api/wire";
import { figures } from "../controls/format";
import { inUnit, measured, unitOf } from "../controls/lengths";
import type { PlainId } from "../messages/text";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { type LiveState, useLive } from "../state/store";
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

/** Name of the scan that deviations are from; empty if they are from a fitted shape. */
export const referenceOf = ({ library }: LiveState): string => library?.opened?.comparison?.reference ?? "";

/** What the colours mean. */
export function titleOf({ measure }: Legend, reference: string): string {
  const from = measure === "deviation" && reference;
  return from ? t("ui-deviation-from-scan", { name: isolated(from) }) : t(MEASURES[measure].legend);
}

/** Weak places, the gravest first, in the colours of the station (app/crenel/station/view3d/cloud_colouring.py). */
export const WEAK: { why: "fast" | "steep" | "few"; name: PlainId; colour: string }[] = [
  { why: "fast", name: "ui-scanned-too-fast", colour: "rgb(222 30 130)" },
  { why: "steep", name: "ui-seen-too-steeply", colour: "rgb(244 96 20)" },
  { why: "few", name: "ui-few-points", colour: "rgb(124 124 132)" },
];

function shareOf(some: number, all: number): string {
  const percent = (100 * some) / Math.max(all, 1);
  return percent < 1 ? "< 1\u00a0%" : measured(percent, "%");
}

/** Legend of the colours: a bar with its ends and its middle. */
export function LegendBar({ legend }: { legend: Legend }) {
  const content = useLive((s) => s.view?.content);
  const shown = useLive((s) => (s.view?.scans ?? []).reduce((sum, { points_shown }) => sum + points_shown, 0));
  const weak = content?.weak_shown ? WEAK.filter(({ why }) => (content.weak_points[why] ?? 0) > 0) : [];
  const reference = useLive(referenceOf);
  const { unit, low, high } = inDisplayedUnit(legend);
  const decimals = decimalsOf({ low, high });
  return (
    <figure className={styles.legend}>
      {weak.length > 0 && (
        <ul className={styles.weak} aria-label={t("ui-weak-places")}>
          {weak.map(({ why, name, colour }) => (
            <li key={why}>
              <span className={styles.swatch} style={{ background: colour }} aria-hidden="true" />
              {t(name)} <span className={styles.share}>{shareOf(content?.weak_points[why] ?? 0, shown)}</span>
            </li>
          ))}
        </ul>
      )}
      <figcaption className={styles.title}>
        {titleOf(legend, reference)}
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
