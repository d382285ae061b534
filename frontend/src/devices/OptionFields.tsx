import { useId } from "react";

import type { Options } from "../api/deviceCommands";
import type { OptionField, OptionOffer } from "../api/wire";
import look from "../controls/Control.module.css";
import fields from "../controls/Field.module.css";
import settings from "../settings/Settings.module.css";
import { t } from "../state/language";
import styles from "./Devices.module.css";
import { optionHelp } from "./optionTexts";

interface OptionFieldsProps {
  fields: OptionField[];
  options: Options;
  /** What the open device offers; none before it is open. */
  offers: OptionOffer[];
  /** The fields at the top; the others are under "More options". */
  isMain: (field: OptionField) => boolean;
  onChange: (options: Options) => void;
}

/** The options of a driver: those needed most at once, the others on request. */
export function OptionFields({ fields: all, options, offers, isMain, onChange }: OptionFieldsProps) {
  const row = (field: OptionField) => (
    <OptionInput
      key={field.key}
      field={field}
      offer={offers.find((one) => one.key === field.key)}
      value={options[field.key]}
      onValue={(value) => onChange({ ...options, [field.key]: value })}
    />
  );
  const more = all.filter((field) => !isMain(field));
  return (
    <>
      {all.filter(isMain).map(row)}
      {more.length > 0 && (
        <details className={styles.more}>
          <summary>{t("ui-more-options")}</summary>
          <div className={styles.fields}>{more.map(row)}</div>
        </details>
      )}
    </>
  );
}

interface OptionInputProps {
  field: OptionField;
  offer: OptionOffer | undefined;
  value: unknown;
  onValue: (value: string | boolean) => void;
}

function OptionInput({ field, offer, value, onValue }: OptionInputProps) {
  const id = useId();
  const { kind, key, unit, words } = field;
  const help = optionHelp(field, offer);
  const choices = choicesOf(field, offer, text(value));
  const label = unit ? `${field.label} (${unit})` : field.label;
  if (kind === "switch") {
    return (
      <label className={settings.switch}>
        <input
          type="checkbox"
          checked={value === undefined ? field.default === "true" : value === true || value === "true"}
          onChange={(event) => onValue(event.target.checked)}
        />
        {label}
      </label>
    );
  }
  const common = { id, className: `${look.input} ${fields.input}`, "aria-describedby": `${id}-help` };
  return (
    <div className={fields.field}>
      <label className={fields.label} htmlFor={id}>
        {label}
      </label>
      {choices.length > 0 ? (
        <select {...common} value={text(value)} onChange={(event) => onValue(event.target.value)}>
          <option value="">{words[field.default] ?? (field.default || "–")}</option>
          {choices.map((choice) => (
            <option key={choice} value={choice}>
              {words[choice] ?? choice}
            </option>
          ))}
        </select>
      ) : (
        <input
          {...common}
          type="text"
          inputMode={kind === "number" ? "decimal" : "text"}
          value={text(value)}
          placeholder={field.default}
          required={field.required}
          autoComplete="off"
          autoCapitalize="off"
          spellCheck={false}
          onChange={(event) => onValue(event.target.value)}
        />
      )}
      <p id={`${id}-help`} className={fields.help}>
        {help && `${help} `}
        <code>{key}</code>
      </p>
    </div>
  );
}

/** The values to choose from, besides the default; none of an option that is typed. */
function choicesOf(field: OptionField, offer: OptionOffer | undefined, value: string): string[] {
  const { choices } = field.kind === "choice" ? field : (offer ?? { choices: [] });
  if (choices.length === 0) return [];
  return [...new Set([...choices, value])].filter((one) => one !== "" && one !== field.default);
}

function text(value: unknown): string {
  if (value === undefined || value === null) return "";
  return Array.isArray(value) ? value.join(", ") : String(value);
}
