import { useEffect } from "react";

import { changeSettings, readSettings } from "../api/settingsCommands";
import { CardHead } from "../controls/CardHead";
import fields from "../controls/Field.module.css";
import { Findings } from "../controls/Findings";
import card from "../controls/Section.module.css";
import { SensorSegments } from "../controls/SensorSegments";
import { Layout } from "../frame/Layout";
import { LiveCamera } from "../image/LiveCamera";
import { DelaySettings } from "../settings/DelaySettings";
import { LanguageSettings } from "../settings/LanguageSettings";
import { LineSettings } from "../settings/LineSettings";
import { LogoSettings } from "../settings/LogoSettings";
import { NumberSetting } from "../settings/NumberSetting";
import styles from "../settings/Settings.module.css";
import { UnattendedSettings } from "../settings/UnattendedSettings";
import { useZones } from "../settings/useZones";
import { ZoneButtons } from "../settings/ZoneButtons";
import { ZoneEditor } from "../settings/ZoneEditor";
import { t } from "../state/language";
import { useLive } from "../state/store";

/** Settings for scans, beside the live picture, which shows their effect at once. */
export function SettingsPage() {
  const settings = useLive((s) => s.settings);
  const laser = useLive((s) => s.devices !== null && s.devices.laser.state !== "off");
  const admin = useLive((s) => s.session?.you?.role === "admin");
  const zones = useZones(settings);
  useEffect(() => void readSettings(), []);
  if (!settings) {
    return (
      <Layout
        picture={<LiveCamera />}
        card={<CardHead title={t("ui-settings")} text={t("ui-waiting-for-the-station")} />}
      />
    );
  }
  return (
    <Layout
      picture={<LiveCamera over={(frame) => <ZoneEditor frame={frame} current={settings.zones} zones={zones} />} />}
      card={
        <>
          <CardHead
            title={t("ui-scan-settings")}
            text={
              laser
                ? t("ui-detected-line-drawn-red-picture-changes")
                : t("ui-switch-laser-display-detected-line-changes")
            }
          />
          <SensorSegments />
          <Findings findings={settings.findings} />
          <ZoneButtons zones={zones} settings={settings} />
          <LineSettings settings={settings} />
          <section className={card.section} aria-labelledby="speed">
            <h2 id="speed" className={card.heading}>
              {t("ui-speed")}
            </h2>
            <NumberSetting
              name="blur_limit_mm"
              label={t("ui-blur-above-which-pass-too-fast")}
              unit="mm"
              help={t("ui-motion-part-under-line-during-one")}
              settings={settings}
            />
          </section>
          <section className={card.section} aria-labelledby="recording">
            <h2 id="recording" className={card.heading}>
              {t("ui-recording")}
            </h2>
            <label className={styles.switch}>
              <input
                type="checkbox"
                checked={settings.record_pictures}
                onChange={(event) => void changeSettings({ record_pictures: event.target.checked })}
              />
              {t("ui-also-record-pictures")}
            </label>
            <p className={fields.help}>{t("ui-pictures-take-about-30-mb-per")}</p>
          </section>
          <UnattendedSettings settings={settings} />
          <DelaySettings settings={settings} />
          {admin && <LogoSettings />}
          <LanguageSettings />
        </>
      }
    />
  );
}
