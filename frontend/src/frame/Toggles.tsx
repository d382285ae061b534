import { useComputedColorScheme, useMantineColorScheme } from "@mantine/core";
import { HelpIcon, MoonIcon, MutedIcon, SoundIcon, SunIcon } from "../controls/icons";
import { showHelp } from "../guidance/help";
import { t } from "../state/language";
import { toggleMuted, useMuted } from "../state/sounds";
import { LanguageMenu } from "./LanguageMenu";
import styles from "./Toggles.module.css";

export function Toggles() {
  return (
    <div className={styles.toggles}>
      <LanguageMenu>
        <DisplayToggles />
      </LanguageMenu>
      <span className={styles.wide} data-part="help">
        <DisplayToggles />
      </span>
    </div>
  );
}

export function DisplayToggles() {
  return (
    <span className={styles.row}>
      <SoundToggle />
      <SchemeToggle />
      <HelpToggle />
    </span>
  );
}

function HelpToggle() {
  const label = t("ui-keyboard-and-tour");
  return (
    <button
      type="button"
      className={styles.toggle}
      onClick={() => showHelp(true)}
      aria-haspopup="dialog"
      aria-label={label}
      title={label}
    >
      <HelpIcon />
    </button>
  );
}

function SoundToggle() {
  const muted = useMuted();
  const label = muted ? t("ui-sounds-on") : t("ui-sounds-off");
  return (
    <button type="button" className={styles.toggle} onClick={toggleMuted} aria-label={label} title={label}>
      {muted ? <MutedIcon /> : <SoundIcon />}
    </button>
  );
}

function SchemeToggle() {
  const { setColorScheme } = useMantineColorScheme();
  const scheme = useComputedColorScheme("light");
  const other = scheme === "dark" ? "light" : "dark";
  const label = other === "dark" ? t("ui-dark-display") : t("ui-light-display");
  return (
    <button
      type="button"
      className={styles.toggle}
      onClick={() => setColorScheme(other)}
      aria-label={label}
      title={label}
    >
      {scheme === "dark" ? <SunIcon /> : <MoonIcon />}
    </button>
  );
}
