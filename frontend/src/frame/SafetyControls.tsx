import { setLaser, stopAll } from "../api/commands";
import type { Devices } from "../api/wire";
import { LaserIcon, StopIcon } from "../controls/icons";
import { SHORTCUTS } from "../guidance/shortcuts";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./SafetyControls.module.css";

/** Laser and Stop: the same place on every page, acting at once, never waiting for an answer. */
export function SafetyControls() {
  return (
    <div className={styles.controls} data-part="stop" role="group" aria-label={t("ui-safety")}>
      <LaserButton />
      <button
        type="button"
        className={styles.stop}
        aria-keyshortcuts={SHORTCUTS.stop.keys}
        onClick={() => void stopAll()}
      >
        <StopIcon />
        <span>{t("ui-stop")}</span>
      </button>
    </div>
  );
}

type Laser = Devices["laser"];

/** What is believed, and from what. */
const GROUNDS: Record<Laser["known_from"], PlainId> = {
  switch: "ui-laser-as-switched-here",
  "no-switch": "ui-laser-has-no-switch-here",
  "no-answer": "ui-laser-sensor-did-not-answer",
  lost: "ui-laser-camera-is-lost",
  absent: "ui-laser-no-camera-yet",
};

function laserWords(laser: Laser | null): { state: string; act: string } {
  switch (laser?.state) {
    case "on":
      return { state: t("ui-laser-is-on"), act: t("ui-laser-off") };
    case "off":
      return { state: t("ui-laser-is-off"), act: t("ui-switch-on") };
    default:
      return { state: t("ui-laser-unknown"), act: t("ui-laser-off") };
  }
}

function LaserButton() {
  const laser = useLive((s) => (s.connection === "live" ? (s.devices?.laser ?? null) : null));
  const { state, act } = laserWords(laser);
  const ground = laser ? t(GROUNDS[laser.known_from]) : t("ui-waiting-for-the-station");
  const switchable = laser?.known_from !== "no-switch";
  // switched off unless it is known to be off
  const press = () => void setLaser(laser?.state === "off");
  return (
    <button
      type="button"
      className={styles.laser}
      data-on={laser?.state === "on" || undefined}
      aria-disabled={!switchable || undefined}
      title={ground}
      onClick={switchable ? press : undefined}
      onKeyDown={(event) => event.repeat && event.preventDefault()}
    >
      <LaserIcon />
      <span className={styles.words}>
        <span className={styles.state}>
          {state}
          {laser?.state === "unknown" && <span className={styles.ground}>: {ground}</span>}
        </span>
        <span className={styles.act}>{switchable ? act : t("ui-switch-at-the-sensor")}</span>
      </span>
    </button>
  );
}
