import type { StationSettings } from "../api/wire";
import fields from "../controls/Field.module.css";
import { PressButton } from "../controls/PressButton";
import card from "../controls/Section.module.css";
import { t } from "../state/language";
import styles from "./Settings.module.css";
import type { Zones } from "./useZones";

/** Zones are drawn on the picture; these buttons do everything else with them. */
export function ZoneButtons({ zones, settings }: { zones: Zones; settings: StationSettings }) {
  const count = settings.zones.length;
  return (
    <section className={card.section} aria-labelledby="zones">
      <h2 id="zones" className={card.heading}>
        {t("ui-zones-without-measurement")}
      </h2>
      <p className={fields.help}>
        {zones.drawing
          ? t("ui-draw-press-picture-drag")
          : count === 0
            ? t("ui-mask-shines-picture-not-part-object")
            : `${t("ui-zones", { n: count })}. ${t("ui-drag-corner-move-small-dot-add")}`}
      </p>
      <div className={styles.buttons}>
        <PressButton onPress={() => zones.setDrawing(!zones.drawing)}>
          {zones.drawing ? t("ui-stop-drawing") : t("ui-draw-a-zone")}
        </PressButton>
        <PressButton onPress={zones.undo} disabled={!zones.canUndo}>
          {t("ui-undo")}
        </PressButton>
        <PressButton onPress={() => zones.set([])} disabled={count === 0}>
          {t("ui-clear")}
        </PressButton>
      </div>
    </section>
  );
}
