import { type ReactNode, useId } from "react";

import { changeSettings } from "../api/settingsCommands";
import type { StationSettings } from "../api/wire";
import fields from "../controls/Field.module.css";
import { unitOf } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { UnitInput } from "../controls/UnitInput";
import { useFieldForm } from "../controls/useFieldForm";
import { useLengthField } from "../controls/useLengthField";
import { t } from "../state/language";

type Name =
  | "threshold"
  | "min_width_px"
  | "max_width_px"
  | "smoothing_px"
  | "exposure_us"
  | "blur_limit_mm"
  | "unattended_stop_s";

interface NumberSettingProps {
  name: Name;
  label: string;
  unit: string;
  /** The effect of the number, and the automatic value. */
  help: string;
  settings: StationSettings;
  placeholder?: string;
  children?: ReactNode;
}

/** One number of the settings; an empty field means automatic. */
export function NumberSetting(props: NumberSettingProps) {
  const { name, label, unit, help, settings, placeholder = t("ui-automatic-lowercase"), children } = props;
  const id = useId();
  const field = useLengthField(settings[name], unit);
  const set = async () => {
    await changeSettings({ [name]: field.value });
  };
  const { changed, valid, form } = useFieldForm([field], set);
  return (
    <form className={fields.field} {...form}>
      <label className={fields.label} htmlFor={id}>
        {label}
      </label>
      <div className={fields.row}>
        <UnitInput
          id={id}
          unit={unitOf(unit)}
          long={unit.length > 4}
          value={field.text}
          placeholder={placeholder}
          aria-describedby={`${id}-help`}
          onText={field.setText}
        />
        {changed ? (
          <PressButton onPress={set} disabled={!valid}>
            {t("ui-set")}
          </PressButton>
        ) : (
          children
        )}
      </div>
      <p id={`${id}-help`} className={fields.help}>
        {help}
      </p>
    </form>
  );
}
