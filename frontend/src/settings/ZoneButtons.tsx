import type { StationSettings } from "../api/settingsTypes";
import fields from "../parts/Field.module.css";
import { PressButton } from "../parts/PressButton";
import { counted, t } from "../state/language";
import type { Zones } from "./useZones";
import styles from "./Settings.module.css";

/** Zones are drawn on the picture; what else is done with them is done here. */
export function ZoneButtons({ zones, settings }: { zones: Zones; settings: StationSettings }) {
  const count = settings.zones.length;
  return (
    <section className={styles.section} aria-labelledby="zones">
      <h2 id="zones" className={styles.heading}>
        {t("Zones without measurement")}
      </h2>
      <p className={fields.help}>
        {zones.drawing
          ? t("Draw it: press on the picture, and pull.")
          : count === 0
            ? t("Hide what shines in the picture and is no part: a clamp, the sensor’s own edge.")
            : `${counted(count, "{n} zone", "{n} zones")}. ${t("Pull a corner to move it, a small dot to make a new corner; Delete takes a corner away.")}`}
      </p>
      <div className={styles.buttons}>
        <PressButton onPress={() => zones.setDrawing(!zones.drawing)}>
          {zones.drawing ? t("Draw nothing") : t("Draw a zone")}
        </PressButton>
        <PressButton onPress={zones.undo} disabled={!zones.canUndo}>
          {t("Undo")}
        </PressButton>
        <PressButton onPress={() => zones.set([])} disabled={count === 0}>
          {t("Clear")}
        </PressButton>
      </div>
    </section>
  );
}
