import { type FormEvent, type ReactNode, useId } from "react";

import { changeSettings } from "../api/settingsCommands";
import type { StationSettings } from "../api/settingsTypes";
import fields from "../parts/Field.module.css";
import { unitOf } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { UnitInput } from "../parts/UnitInput";
import { useHeldLength } from "../parts/useHeldLength";
import { t } from "../state/language";

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
    <form className={fields.field} onSubmit={submit}>
      <label className={fields.label} htmlFor={id}>
        {label}
      </label>
      <div className={fields.row}>
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
      <p id={`${id}-help`} className={fields.help}>
        {help}
      </p>
    </form>
  );
}
