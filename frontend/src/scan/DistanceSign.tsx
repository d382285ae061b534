import type { Distance } from "../api/wire";
import { lengthFigures, unitOf } from "../controls/lengths";
import { QualityMark } from "../controls/QualityMark";
import { type PlainId, quantity } from "../messages/text";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./DistanceSign.module.css";

const STATES: Record<Distance["state"], PlainId> = { in: "ui-in-range", near: "ui-too-near", far: "ui-too-far" };

/** How far the sensor is from the part, readable from two metres. */
export function DistanceSign() {
  const distance = useLive((s) => s.view?.distance ?? null);
  if (!distance) return null;
  const good = distance.state === "in";
  return (
    <div className={styles.sign} data-quality={good ? "good" : "bad"}>
      <p className={styles.words}>
        <QualityMark quality={good ? "good" : "bad"} size="1.5rem" />
        {t(STATES[distance.state])}
      </p>
      <p className={styles.value}>
        {lengthFigures(distance.mm, "mm")}
        <span className={styles.unit}>{unitOf("mm")}</span>
      </p>
      <p className={styles.range}>
        {t("ui-calibrated-to", { low: lengthFigures(distance.near_mm, "mm"), high: quantity(distance.far_mm, "mm") })}
      </p>
    </div>
  );
}
