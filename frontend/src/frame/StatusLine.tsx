import type { ReactNode } from "react";

import type { DeviceState } from "../api/deviceTypes";
import { age, days, figures } from "../parts/format";
import { useSilence } from "../state/freshness";
import { t, words } from "../state/language";
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
          <Device name={t("arm")} device={devices.arm} figure={freshness(devices.arm, live ? 0 : silent_s)} />
          <Device name={t("camera")} device={devices.sensor} figure={rate(devices.sensor)} />
          <Item minor>{t("disk {n} GB", { n: figures(devices.disk_free_gb) })}</Item>
        </>
      )}
      {home && (
        <Item>{calibration ? t("calibration: {age} old", { age: days(calibration.age_days) }) : t("no calibration yet")}</Item>
      )}
      {!live && <Item>{t("as of {age} ago", { age: age(silent_s) })}</Item>}
    </footer>
  );
}

function freshness(device: DeviceState, more_s: number): string {
  return device.age_s === null ? t("no data") : age(device.age_s + more_s);
}

function rate(device: DeviceState): string {
  return device.rate_hz === null ? t("no pictures") : t("{n} fps", { n: figures(device.rate_hz) });
}

const STATES: Record<DeviceState["state"], string> = {
  connected: words("connected"),
  connecting: words("connecting"),
  lost: words("lost"),
  off: words("off"),
};

function stateWords({ state, age_s }: DeviceState): string {
  return state === "lost" && age_s !== null ? t("lost for {age}", { age: age(age_s) }) : t(STATES[state]);
}

function Device({ name, device, figure }: { name: string; device: DeviceState; figure: string }) {
  return (
    <Item>
      {name} <span className={styles.dot} data-state={device.state} /> {device.state === "connected" ? figure : stateWords(device)}
    </Item>
  );
}

function Item({ children, minor = false }: { children: ReactNode; minor?: boolean }) {
  return <span className={styles.item} data-minor={minor || undefined}>{children}</span>;
}
