import { setLaser, stopAll } from "../api/commands";
import type { Devices } from "../api/types";
import { LaserIcon, StopIcon } from "../parts/icons";
import { useLive } from "../state/store";
import styles from "./SafetyControls.module.css";

/** Laser and Stop: the same place on every page, acting at once, never waiting for an answer. */
export function SafetyControls() {
  return (
    <div className={styles.controls} role="group" aria-label="Safety">
      <LaserButton />
      <button type="button" className={styles.stop} onClick={() => void stopAll()}>
        <StopIcon />
        <span>STOP</span>
      </button>
    </div>
  );
}

function laserWords(devices: Devices | null, live: boolean): { state: string; act: string; on: boolean } {
  if (!devices || !live) return { state: "Laser unknown", act: "LASER OFF", on: false };
  if (devices.laser_on) return { state: "Laser is on", act: "LASER OFF", on: true };
  return { state: "Laser is off", act: "Switch on", on: false };
}

function LaserButton() {
  const devices = useLive((s) => s.devices);
  const live = useLive((s) => s.connection === "live");
  const { state, act, on } = laserWords(devices, live);
  const switchable = !devices || devices.has_laser_switch;
  const press = () => void setLaser(act === "Switch on");
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
        <span className={styles.act}>{switchable ? act : "Switch at the sensor"}</span>
      </span>
    </button>
  );
}
