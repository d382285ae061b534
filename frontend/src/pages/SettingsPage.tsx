import { useEffect } from "react";

import { changeSettings, readSettings } from "../api/settingsCommands";
import { Layout } from "../frame/Layout";
import { LiveCamera } from "../image/LiveCamera";
import { CardHead } from "../parts/CardHead";
import fields from "../parts/Field.module.css";
import { Findings } from "../parts/Findings";
import { DelaySettings } from "../settings/DelaySettings";
import { LanguageSettings } from "../settings/LanguageSettings";
import { LineSettings } from "../settings/LineSettings";
import { NumberSetting } from "../settings/NumberSetting";
import styles from "../settings/Settings.module.css";
import { useZones } from "../settings/useZones";
import { ZoneButtons } from "../settings/ZoneButtons";
import { ZoneEditor } from "../settings/ZoneEditor";
import { t } from "../state/language";
import { useLive } from "../state/store";

/** What an operator sets of scans, beside the live picture on which it shows at once. */
export function SettingsPage() {
  const settings = useLive((s) => s.settings);
  const laser = useLive((s) => s.devices?.laser_on ?? false);
  const zones = useZones(settings);
  useEffect(() => void readSettings(), []);
  if (!settings) {
    return <Layout picture={<LiveCamera />} card={<CardHead title={t("Settings")} text={t("Waiting for the station.")} />} />;
  }
  return (
    <Layout
      picture={
        <LiveCamera over={(frame) => <ZoneEditor frame={frame} held={settings.zones} zones={zones} />} />
      }
      card={
        <>
          <CardHead
            title={t("Settings of scans")}
            text={
              laser
                ? t("The line that is found is drawn red on the picture. Every change is in use at once, and kept.")
                : t("Switch the laser on to see the line that is found. Every change is in use at once, and kept.")
            }
          />
          <Findings findings={settings.findings} />
          <ZoneButtons zones={zones} settings={settings} />
          <LineSettings settings={settings} />
          <section className={styles.section} aria-labelledby="speed">
            <h2 id="speed" className={styles.heading}>
              {t("Speed")}
            </h2>
            <NumberSetting
              name="blur_limit_mm"
              label={t("Blur from which a pass is too fast")}
              unit="mm"
              help={t("The part’s way under the line during one exposure. Automatic: four times the spacing of the points along the line.")}
              settings={settings}
            />
          </section>
          <section className={styles.section} aria-labelledby="recording">
            <h2 id="recording" className={styles.heading}>
              {t("Recording")}
            </h2>
            <label className={styles.switch}>
              <input
                type="checkbox"
                checked={settings.record_pictures}
                onChange={(event) => void changeSettings({ record_pictures: event.target.checked })}
              />
              {t("Record pictures, too")}
            </label>
            <p className={fields.help}>
              {t("They take some 30 MB a second, and can be extracted anew. Every line is recorded in any case, and comes first.")}
            </p>
          </section>
          <DelaySettings settings={settings} />
          <LanguageSettings />
        </>
      }
    />
  );
}
