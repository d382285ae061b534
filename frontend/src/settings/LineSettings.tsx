import { changeSettings, exposeByTheLine } from "../api/settingsCommands";
import type { StationSettings } from "../api/wire";
import look from "../controls/Control.module.css";
import fields from "../controls/Field.module.css";
import { PressButton } from "../controls/PressButton";
import card from "../controls/Section.module.css";
import { t } from "../state/language";
import { LINE_CHOICES, type LineChoice } from "./lineChoices";
import { NumberSetting } from "./NumberSetting";

/** How the laser line is distinguished from everything else that is bright. */
export function LineSettings({ settings }: { settings: StationSettings }) {
  return (
    <section className={card.section} aria-labelledby="line">
      <h2 id="line" className={card.heading}>
        {t("ui-laser-line")}
      </h2>
      <NumberSetting
        name="exposure_us"
        label={t("ui-exposure")}
        unit="µs"
        placeholder={t("ui-unchanged")}
        help={t("ui-scans-short-bright-metal-long-dark")}
        settings={settings}
      >
        <PressButton onPress={exposeByTheLine}>{t("ui-adjust-to-the-line")}</PressButton>
      </NumberSetting>
      <NumberSetting
        name="threshold"
        label={t("ui-threshold")}
        unit={t("ui-grey-levels")}
        help={t("ui-far-line-exceeds-surroundings-automatic-four")}
        settings={settings}
      />
      <NumberSetting
        name="min_width_px"
        label={t("ui-minimum-width")}
        unit="px"
        help={t("ui-narrower-lines-glints-automatic-about-half")}
        settings={settings}
      />
      <NumberSetting
        name="max_width_px"
        label={t("ui-maximum-width")}
        unit="px"
        help={t("ui-wider-lines-surfaces-automatic-about-twice")}
        settings={settings}
      />
      <NumberSetting
        name="smoothing_px"
        label={t("ui-smoothing-along-the-line")}
        unit="px"
        placeholder={t("ui-none")}
        help={t("ui-smoothing-quieter-points-less-detail")}
        settings={settings}
      />
      <label className={fields.field}>
        <span className={fields.label}>{t("ui-where-several-lines-cross-a-column")}</span>
        <select
          className={`${look.input} ${fields.input}`}
          value={settings.choice}
          onChange={(event) => void changeSettings({ choice: event.target.value as LineChoice })}
        >
          {LINE_CHOICES.map(({ value, label }) => (
            <option key={value} value={value}>
              {t(label)}
            </option>
          ))}
        </select>
        <span className={fields.help}>{t("ui-take-first-last-glass-film-where")}</span>
      </label>
    </section>
  );
}
