import { selectSensor } from "../api/commands";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { Segments } from "./Segments";
import styles from "./SensorSegments.module.css";

/** Which of several sensors is seen, switched and exposed; nothing at a station with one. */
export function SensorSegments() {
  const choice = useLive((s) => s.sensors);
  if (!choice) return null;
  return (
    <div className={styles.choice}>
      <Segments
        label={t("ui-sensor-selected")}
        options={choice.sensors.map(({ name, label }) => ({ value: name, label }))}
        value={choice.selected}
        onChange={(name) => void selectSensor(name)}
        wide
      />
    </div>
  );
}
