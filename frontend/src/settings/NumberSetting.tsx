import { type FormEvent, type ReactNode, useId } from "react";

import { changeSettings } from "../api/settingsCommands";
import type { StationSettings } from "../api/settingsTypes";
import { UnitInput } from "../arm/UnitInput";
import { unitOf } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { useHeldLength } from "../parts/useHeldLength";
import { t } from "../state/language";
import styles from "./Settings.module.css";

type Name = "threshold" | "min_width_px" | "exposure_us" | "blur_limit_mm";

interface NumberSettingProps {
  name: Name;
  label: string;
  unit: string;
  /** What the number does, and what is done without one. */
  help: string;
  settings: StationSettings;
  placeholder?: string;
  children?: ReactNode;
}

/** One number of the settings; an empty field leaves it to the station. */
export function NumberSetting(props: NumberSettingProps) {
  const { name, label, unit, help, settings, placeholder = t("automatic"), children } = props;
  const id = useId();
  const held = useHeldLength(settings[name], unit);
  const set = async () => {
    await changeSettings({ [name]: held.value });
  };
  const submit = (event: FormEvent) => {
    event.preventDefault();
    void set();
  };
  return (
    <form className={styles.field} onSubmit={submit}>
      <label className={styles.label} htmlFor={id}>
        {label}
      </label>
      <div className={styles.row}>
        <UnitInput
          id={id}
          unit={unitOf(unit)}
          long={unit.length > 4}
          value={held.text}
          placeholder={placeholder}
          aria-describedby={`${id}-help`}
          onText={held.setText}
        />
        {held.changed ? <PressButton onPress={set}>{t("Set")}</PressButton> : children}
      </div>
      <p id={`${id}-help`} className={styles.help}>
        {help}
      </p>
    </form>
  );
}
