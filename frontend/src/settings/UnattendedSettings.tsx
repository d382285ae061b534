import { changeSettings } from "../api/settingsCommands";
import type { StationSettings } from "../api/wire";
import fields from "../controls/Field.module.css";
import card from "../controls/Section.module.css";
import { t } from "../state/language";
import { NumberSetting } from "./NumberSetting";
import styles from "./Settings.module.css";

/** When scan and laser are stopped because nobody is in control and the arm stands still. */
export function UnattendedSettings({ settings }: { settings: StationSettings }) {
  return (
    <section className={card.section} aria-labelledby="unattended">
      <h2 id="unattended" className={card.heading}>
        {t("ui-nobody-in-control")}
      </h2>
      {!settings.runs_unattended && (
        <NumberSetting
          name="unattended_stop_s"
          label={t("ui-scan-and-laser-stop-after")}
          unit="s"
          placeholder="30"
          help={t("ui-when-browser-in-control-is-gone")}
          settings={settings}
        />
      )}
      <label className={styles.switch}>
        <input
          type="checkbox"
          checked={settings.runs_unattended}
          onChange={(event) => void changeSettings({ runs_unattended: event.target.checked })}
        />
        {t("ui-runs-unattended")}
      </label>
      <p className={fields.help}>{t("ui-for-robot-cells-no-stop")}</p>
    </section>
  );
}
