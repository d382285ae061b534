import type { DeviceLine } from "../api/wire";
import { QualityMark } from "../controls/QualityMark";
import { t } from "../state/language";
import styles from "./DevicesPicture.module.css";

/** Each device and whether it is ready for use. */
export function DevicesPicture({ devices }: { devices: DeviceLine[] }) {
  return (
    <ul className={styles.devices} aria-label={t("ui-devices")}>
      {devices.map((device) => (
        <li key={device.title} className={styles.device}>
          <QualityMark quality={device.quality} size="2rem" />
          <div>
            <p className={styles.title}>{device.title}</p>
            <p className={styles.text}>{device.text}</p>
          </div>
        </li>
      ))}
    </ul>
  );
}
