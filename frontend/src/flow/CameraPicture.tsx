import { setExposure } from "../api/commands";
import { measured } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { LiveCamera } from "../image/LiveCamera";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./CameraPicture.module.css";

/** One press changes the brightness by a fifth: a small step that is still visible. */
const FACTOR = 1.25;

interface CameraPictureProps {
  /** The object as it would look from the suggested hold; empty without a suggestion. */
  target: [number, number, number, number][];
}

/** The live camera, with its exposure. */
export function CameraPicture({ target }: CameraPictureProps) {
  const exposure_us = useLive((s) => s.devices?.exposure_us ?? null);
  return (
    <div className={styles.picture}>
      <LiveCamera target={target} />
      {exposure_us !== null && (
        <div className={styles.exposure} role="group" aria-label={t("ui-exposure")}>
          <span className={styles.label}>
            <span className={styles.word}>{t("ui-exposure")} </span>
            {measured(exposure_us, "µs")}
          </span>
          <PressButton onPress={() => setExposure(exposure_us / FACTOR)}>{t("ui-darker")}</PressButton>
          <PressButton onPress={() => setExposure(exposure_us * FACTOR)}>{t("ui-brighter")}</PressButton>
        </div>
      )}
    </div>
  );
}
