import { Popover } from "@mantine/core";
import { useState } from "react";
import { ChooseLanguage, ChooseUnits } from "../controls/ChooseLanguage";
import look from "../controls/Control.module.css";
import { MenuIcon } from "../controls/icons";
import { useHelp } from "../guidance/help";
import { t } from "../state/language";
import { type Page, TITLES } from "../state/router";
import styles from "./PageMenu.module.css";
import { PageLinks } from "./Rail";
import { DisplayToggles } from "./Toggles";

/** The pages, and what this browser chooses for itself, where neither has a place of its own. */
export function PageMenu({ page }: { page: Page }) {
  const [opened, setOpened] = useState(false);
  const helps = useHelp();
  const title = t(TITLES[page]);
  return (
    <Popover
      opened={opened && !helps}
      onChange={setOpened}
      position="bottom-start"
      shadow="md"
      radius="md"
      trapFocus
      returnFocus
      zIndex={310}
    >
      <Popover.Target>
        <button
          type="button"
          className={`${look.button} ${styles.button}`}
          data-part="pages"
          aria-label={t("ui-pages-here", { page: title })}
          aria-haspopup="dialog"
          aria-expanded={opened}
          onClick={() => setOpened(!opened)}
        >
          <MenuIcon />
          <span className={styles.here}>{title}</span>
        </button>
      </Popover.Target>
      <Popover.Dropdown className={styles.menu} aria-label={t("ui-pages")}>
        <PageLinks page={page} onGo={() => setOpened(false)} />
        <div className={styles.choices}>
          <ChooseLanguage id="page-menu-language" />
          <ChooseUnits id="page-menu-units" />
          <DisplayToggles />
        </div>
      </Popover.Dropdown>
    </Popover>
  );
}
