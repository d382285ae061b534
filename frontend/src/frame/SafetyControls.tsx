import { setLaser, stopAll } from "../api/commands";
import type { Devices } from "../api/wire";
import { LaserIcon, StopIcon } from "../parts/icons";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./SafetyControls.module.css";

/** Laser and Stop: the same place on every page, acting at once, never waiting for an answer. */
export function SafetyControls() {
  return (
    <div className={styles.controls} role="group" aria-label={t("ui-safety")}>
      <LaserButton />
      <button type="button" className={styles.stop} onClick={() => void stopAll()}>
        <StopIcon />
        <span>{t("ui-stop")}</span>
      </button>
    </div>
  );
}

function laserWords(devices: Devices | null, live: boolean): { state: string; act: string; on: boolean } {
  if (!devices || !live) return { state: t("ui-laser-unknown"), act: t("ui-laser-off"), on: false };
  if (devices.laser_on) return { state: t("ui-laser-is-on"), act: t("ui-laser-off"), on: true };
  return { state: t("ui-laser-is-off"), act: t("ui-switch-on"), on: false };
}

function LaserButton() {
  const devices = useLive((s) => s.devices);
  const live = useLive((s) => s.connection === "live");
  const { state, act, on } = laserWords(devices, live);
  const switchable = !devices || devices.has_laser_switch;
  // switched off unless it is known to be off
  const press = () => void setLaser(live && devices !== null && !devices.laser_on);
  return (
    <button
      type="button"
      className={styles.laser}
      data-on={on || undefined}
      aria-disabled={!switchable || undefined}
      onClick={switchable ? press : undefined}
      onKeyDown={(event) => event.repeat && event.preventDefault()}
    >
      <LaserIcon />
      <span className={styles.words}>
        <span className={styles.state}>{state}</span>
        <span className={styles.act}>{switchable ? act : t("ui-switch-at-the-sensor")}</span>
      </span>
    </button>
  );
}
