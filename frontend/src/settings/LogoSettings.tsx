import { useState } from "react";

import { ask } from "../api/commands";
import { drop, post } from "../api/http";
import type { ReportLogo } from "../api/wire";
import fields from "../controls/Field.module.css";
import { FileChooser } from "../controls/FileChooser";
import { PressButton } from "../controls/PressButton";
import card from "../controls/Section.module.css";
import { quantity } from "../messages/text";
import { notify } from "../state/banner";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { useRead } from "../state/useRead";
import styles from "./LogoSettings.module.css";
import settings from "./Settings.module.css";

const PATH = "/api/settings/logo";
/** Of the place for it in a report, and pixels that are sharp there when it is printed. */
const WIDTH = { mm: 60, pixels: 700 };

/** The logo of all reports, for administrators. */
export function LogoSettings() {
  const [changes, setChanges] = useState(0);
  const { value: logo } = useRead<ReportLogo>(PATH, `${changes}`);
  if (!logo) return null;
  const change = async (act: () => Promise<unknown>) => {
    await ask(act, t("ui-the-logo-was-not-changed"));
    setChanges((before) => before + 1);
  };
  const take = async ([file]: FileList) => {
    if (!file) return;
    if (file.size > logo.largest_bytes) {
      const title = t("ui-logo-too-large", { name: isolated(file.name) });
      notify({ quality: "attention", title, remedy: t("ui-save-it-smaller", { pixels: WIDTH.pixels }) });
      return;
    }
    const data_url = await dataUrlOf(file);
    await change(() => post(PATH, { data_url }));
  };
  const largest = quantity(logo.largest_bytes / 1000, "kB");
  return (
    <section className={card.section} aria-labelledby="logo">
      <h2 id="logo" className={card.heading}>
        {t("ui-logo-of-reports")}
      </h2>
      {logo.data_url ? (
        <img className={styles.logo} src={logo.data_url} alt={t("ui-logo-of-reports")} />
      ) : (
        <p className={fields.help}>{logo.trouble || t("ui-there-is-no-logo")}</p>
      )}
      <div className={settings.buttons}>
        <FileChooser id="logo-file" accept="image/png,image/jpeg" free onFiles={take}>
          {t("ui-choose-a-picture")}
        </FileChooser>
        {(logo.data_url || logo.trouble) && (
          <PressButton free onPress={() => change(() => drop(PATH))}>
            {t("ui-remove-the-logo")}
          </PressButton>
        )}
      </div>
      <p className={fields.help}>
        {t("ui-logo-at-the-head-of-reports", { width: WIDTH.mm, largest, pixels: WIDTH.pixels })}
      </p>
    </section>
  );
}

function dataUrlOf(file: File): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(file);
  });
}
