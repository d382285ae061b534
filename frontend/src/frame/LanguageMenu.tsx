import { Popover } from "@mantine/core";
import { type ReactNode, useState } from "react";
import { ChooseLanguage, ChooseUnits } from "../controls/ChooseLanguage";
import { unitOf } from "../controls/lengths";
import { useHelp } from "../guidance/help";
import { nameOf, t, useLanguage } from "../state/language";
import styles from "./LanguageMenu.module.css";
import toggles from "./Toggles.module.css";

/** This browser's language and units, shown in the bar and changed below it; if there is
 *  little space, next to this browser's other settings. */
export function LanguageMenu({ children }: { children: ReactNode }) {
  const language = useLanguage();
  const [opened, setOpened] = useState(false);
  const helps = useHelp();
  const label = `${t("ui-language-and-units")}: ${nameOf(language)}, ${unitOf("mm")}`;
  return (
    <Popover
      opened={opened && !helps}
      onChange={setOpened}
      position="bottom-end"
      shadow="md"
      radius="md"
      trapFocus
      returnFocus
      zIndex={310}
    >
      <Popover.Target>
        <button
          type="button"
          className={`${toggles.toggle} ${styles.sign}`}
          aria-label={label}
          title={label}
          aria-haspopup="dialog"
          aria-expanded={opened}
          onClick={() => setOpened(!opened)}
        >
          <span>{language.toUpperCase()}</span>
          <span>{unitOf("mm")}</span>
        </button>
      </Popover.Target>
      <Popover.Dropdown className={styles.menu} aria-label={t("ui-language-and-units")}>
        <p className={styles.title}>{t("ui-language")}</p>
        <ChooseLanguage id="menu-language" />
        <p className={styles.title}>{t("ui-lengths")}</p>
        <ChooseUnits id="menu-units" />
        <div className={styles.narrow}>{children}</div>
        <p className={styles.help}>{t("ui-applies-browser-files-reports-csv-stay")}</p>
      </Popover.Dropdown>
    </Popover>
  );
}
