import type { ReactNode } from "react";
import type { DeviceState } from "../api/wire";
import { age, days, figures } from "../controls/format";
import { type PlainId, quantity } from "../messages/text";
import { useSilence } from "../state/freshness";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { activityWords } from "./activityWords";
import styles from "./StatusLine.module.css";

/** The age of each device's data in one line; grey, with its age, if the station is offline. */
export function StatusLine() {
  const devices = useLive((s) => s.devices);
  const home = useLive((s) => s.home);
  const { live, silent_s } = useSilence();
  const calibration = home?.calibration;
  const activity = useLive((s) => s.activity?.activity ?? null);
  return (
    <footer className={styles.line} data-stale={!live || undefined}>
      {devices && (
        <>
          <Device
            name={t("ui-arm-lowercase")}
            device={devices.arm}
            figure={freshness(devices.arm, live ? 0 : silent_s)}
          />
          <Device
            name={t("ui-camera-lowercase")}
            device={devices.sensor}
            figure={rate(devices.sensor, live ? 0 : silent_s)}
          />
          {devices.disk_free_gb !== null && (
            <Item minor>{t("ui-disk-space", { space: quantity(devices.disk_free_gb, "GB") })}</Item>
          )}
        </>
      )}
      {home && (
        <Item>
          {calibration ? t("ui-calibration-old", { age: days(calibration.age_days) }) : t("ui-no-calibration-yet")}
        </Item>
      )}
      {activity && <Item>{t("ui-arm-in-use-by", { activity: activityWords(activity) })}</Item>}
      {!live && <Item>{t("ui-as-of-ago", { age: age(silent_s) })}</Item>}
    </footer>
  );
}

function freshness(device: DeviceState, more_s: number): string {
  return device.age_s === null ? t("ui-no-data") : age(device.age_s + more_s);
}

function rate(device: DeviceState, more_s: number): string {
  return device.rate_hz === null ? freshness(device, more_s) : t("ui-fps", { n: device.rate_hz });
}

const STATES: Record<DeviceState["state"], PlainId> = {
  absent: "ui-none-chosen",
  connected: "ui-connected",
  connecting: "ui-connecting",
  lost: "ui-lost",
  off: "ui-off",
};

function stateWords({ state, age_s }: DeviceState): string {
  return state === "lost" && age_s !== null ? t("ui-lost-for", { age: age(age_s) }) : t(STATES[state]);
}

/** The dot and the words say the same: what the station judges, and why. */
function Device({ name, device, figure }: { name: string; device: DeviceState; figure: string }) {
  const words = device.silent ? t("ui-waits-for-a-trigger-or-a-change") : figure;
  return (
    <Item>
      {name} <span className={styles.dot} data-quality={device.quality} />{" "}
      {device.state === "connected" ? words + losses(device) : stateWords(device)}
    </Item>
  );
}

/** What makes the sign of a device that sends data other than good. */
function losses({ quality, lately }: DeviceState): string {
  const n = lately.lost + lately.corrupt;
  if (n === 0 || quality === "good") return "";
  return `, ${t("ui-lost-lately", { n: figures(n), all: figures(n + lately.received) })}`;
}

function Item({ children, minor = false }: { children: ReactNode; minor?: boolean }) {
  return (
    <span className={styles.item} data-minor={minor || undefined}>
      {children}
    </span>
  );
}
