import { changeSettings, exposeByTheLine } from "../api/settingsCommands";
import type { StationSettings } from "../api/settingsTypes";
import fields from "../parts/Field.module.css";
import { PressButton } from "../parts/PressButton";
import { t, words } from "../state/language";
import { NumberSetting } from "./NumberSetting";
import styles from "./Settings.module.css";

const CHOICES: { value: StationSettings["choice"]; label: string }[] = [
  { value: "continuity", label: words("The longest line (automatic)") },
  { value: "strength", label: words("The brightest") },
  { value: "first", label: words("The first, from the picture's top") },
  { value: "last", label: words("The last, from the picture's top") },
];

/** How the laser's line is told from everything else that is bright. */
export function LineSettings({ settings }: { settings: StationSettings }) {
  return (
    <section className={styles.section} aria-labelledby="line">
      <h2 id="line" className={styles.heading}>
        {t("Laser line")}
      </h2>
      <NumberSetting
        name="exposure_us"
        label={t("Exposure")}
        unit="µs"
        placeholder={t("as it is")}
        help={t("Of scans. Short on bright metal, long on dark parts; a long one blurs.")}
        settings={settings}
      >
        <PressButton onPress={exposeByTheLine}>{t("By the line")}</PressButton>
      </NumberSetting>
      <NumberSetting
        name="threshold"
        label={t("Threshold")}
        unit={t("grey levels")}
        help={t("How far the line stands out of its surroundings. Automatic: four times the noise.")}
        settings={settings}
      />
      <NumberSetting
        name="min_width_px"
        label={t("Least width")}
        unit="px"
        help={t("What is narrower is a glint. Automatic: about half of the line's usual width.")}
        settings={settings}
      />
      <label className={fields.field}>
        <span className={fields.label}>{t("Where several lines cross a column")}</span>
        <select
          className={fields.input}
          value={settings.choice}
          onChange={(event) => void changeSettings({ choice: event.target.value as StationSettings["choice"] })}
        >
          {CHOICES.map(({ value, label }) => (
            <option key={value} value={value}>
              {t(label)}
            </option>
          ))}
        </select>
        <span className={fields.help}>{t("Take the first or the last on glass and film, where two surfaces reflect.")}</span>
      </label>
    </section>
  );
}
