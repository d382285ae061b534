import type { Distance } from "../api/viewTypes";
import { QualityMark } from "../parts/QualityMark";
import { lengthFigures, measured, unitOf } from "../parts/lengths";
import { t, words } from "../state/language";
import { useLive } from "../state/store";
import styles from "./DistanceSign.module.css";

const WORDS: Record<Distance["state"], string> = { in: words("In range"), near: words("Too near"), far: words("Too far") };

/** How far the sensor is from the part, readable from two metres. */
export function DistanceSign() {
  const distance = useLive((s) => s.view?.distance ?? null);
  if (!distance) return null;
  const good = distance.state === "in";
  return (
    <div className={styles.sign} data-quality={good ? "good" : "bad"}>
      <p className={styles.words}>
        <QualityMark quality={good ? "good" : "bad"} size="1.5rem" />
        {t(WORDS[distance.state])}
      </p>
      <p className={styles.value}>
        {lengthFigures(distance.mm, "mm")}
        <span className={styles.unit}>{unitOf("mm")}</span>
      </p>
      <p className={styles.range}>
        {t("calibrated {low} to {high}", { low: lengthFigures(distance.near_mm, "mm"), high: measured(distance.far_mm, "mm") })}
      </p>
    </div>
  );
}
