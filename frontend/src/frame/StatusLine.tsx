import type { ReactNode } from "react";

import type { DeviceState } from "../api/types";
import { age, days, figures } from "../parts/format";
import { useSilence } from "../state/freshness";
import { useLive } from "../state/store";
import styles from "./StatusLine.module.css";

/** Each device's freshness in one line; grey, with its age, when the station is not heard. */
export function StatusLine() {
  const devices = useLive((s) => s.devices);
  const home = useLive((s) => s.home);
  const { live, silent_s } = useSilence();
  const calibration = home?.calibration;
  return (
    <footer className={styles.line} data-stale={!live || undefined}>
      {devices && (
        <>
          <Device name="arm" device={devices.arm} figure={freshness(devices.arm, live ? 0 : silent_s)} />
          <Device name="camera" device={devices.sensor} figure={rate(devices.sensor)} />
          <Item minor>disk {figures(devices.disk_free_gb)} GB</Item>
        </>
      )}
      {home && (
        <Item>{calibration ? `calibration: ${days(calibration.age_days)} old` : "no calibration yet"}</Item>
      )}
      {!live && <Item>as of {age(silent_s)} ago</Item>}
    </footer>
  );
}

function freshness(device: DeviceState, more_s: number): string {
  return device.age_s === null ? "no data" : age(device.age_s + more_s);
}

function rate(device: DeviceState): string {
  return device.rate_hz === null ? "no pictures" : `${figures(device.rate_hz)} fps`;
}

function stateWords({ state, age_s }: DeviceState): string {
  return state === "lost" && age_s !== null ? `lost for ${age(age_s)}` : state;
}

function Device({ name, device, figure }: { name: string; device: DeviceState; figure: string }) {
  const words = device.state === "connected" ? figure : stateWords(device);
  return (
    <Item>
      {name} <span className={styles.dot} data-state={device.state} /> {words}
    </Item>
  );
}

function Item({ children, minor = false }: { children: ReactNode; minor?: boolean }) {
  return <span className={styles.item} data-minor={minor || undefined}>{children}</span>;
}
