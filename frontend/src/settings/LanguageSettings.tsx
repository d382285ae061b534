import { ChooseLanguage, ChooseUnits } from "../parts/ChooseLanguage";
import fields from "../parts/Field.module.css";
import { t } from "../state/language";
import styles from "./Settings.module.css";

/** What this browser speaks and measures in; the same as in the bar above. */
export function LanguageSettings() {
  return (
    <section className={styles.section} aria-labelledby="language">
      <h2 id="language" className={styles.heading}>
        {t("Language and units")}
      </h2>
      <ChooseLanguage id="settings-language" />
      <ChooseUnits id="settings-units" />
      <p className={fields.help}>{t("For this browser. Files, reports and CSV keep mm and µm.")}</p>
    </section>
  );
}
