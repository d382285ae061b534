import { ChooseLanguage, ChooseUnits } from "../controls/ChooseLanguage";
import fields from "../controls/Field.module.css";
import card from "../controls/Section.module.css";
import { t } from "../state/language";

/** Language and units of this browser; the same as in the bar above. */
export function LanguageSettings() {
  return (
    <section className={card.section} aria-labelledby="language">
      <h2 id="language" className={card.heading}>
        {t("ui-language-and-units")}
      </h2>
      <ChooseLanguage id="settings-language" />
      <ChooseUnits id="settings-units" />
      <p className={fields.help}>{t("ui-applies-browser-files-reports-csv-stay")}</p>
    </section>
  );
}
