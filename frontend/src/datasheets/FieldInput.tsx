import { useId } from "react";

import look from "../controls/Control.module.css";
import fields from "../controls/Field.module.css";
import { unitOf } from "../controls/lengths";
import settings from "../settings/Settings.module.css";
import { t } from "../state/language";
import styles from "./Datasheets.module.css";
import type { FormField } from "./forms";

interface FieldInputProps {
  field: FormField;
  value: string;
  /** Between which limits its number is; empty if nothing is known. */
  range: string;
  /** What the station finds wrong in it. */
  problem: string;
  onText: (text: string) => void;
}

/** One field of a form: its label with the unit, and beside it what is wrong. */
export function FieldInput({ field, value, range, problem, onText }: FieldInputProps) {
  const id = useId();
  const { label, unit, optional, type } = field;
  if (type === "switch") {
    return (
      <label className={settings.switch}>
        <input type="checkbox" checked={value === "true"} onChange={(event) => onText(String(event.target.checked))} />
        {t(label)}
      </label>
    );
  }
  const title = unit ? t("ui-label-with-unit", { label: t(label), unit: unitOf(unit) }) : t(label);
  return (
    <div className={fields.field} data-field={field.key}>
      <label className={fields.label} htmlFor={id}>
        {optional ? t("ui-optional-field", { label: title }) : title}
      </label>
      <Entry field={field} value={value} range={range} problem={problem} id={id} onText={onText} />
      {problem && (
        <p id={`${id}-problem`} className={styles.problem} role="status">
          {problem}
        </p>
      )}
    </div>
  );
}

/** What is filled in, without its label. */
export function Entry(props: FieldInputProps & { id?: string; label?: string }) {
  const { field, value, range, problem, onText, id, label } = props;
  const common = {
    id,
    className: `${look.input} ${fields.input}`,
    "aria-label": label,
    "aria-invalid": problem !== "" || undefined,
    "aria-describedby": problem && id ? `${id}-problem` : undefined,
    title: label && problem ? problem : undefined,
    value,
  };
  if (field.type === "choice") {
    return (
      <select {...common} onChange={(event) => onText(event.target.value)}>
        {(field.choices ?? []).map((choice) => (
          <option key={choice} value={choice}>
            {choiceText(choice)}
          </option>
        ))}
      </select>
    );
  }
  if (field.type === "list") {
    return (
      <textarea
        {...common}
        className={`${common.className} ${styles.list}`}
        rows={3}
        autoComplete="off"
        onChange={(event) => onText(event.target.value)}
      />
    );
  }
  const isNumber = field.type === "number";
  if (field.type === "date" && /^(\d{4}-\d\d-\d\d)?$/.test(value)) {
    return <input {...common} type="date" onChange={(event) => onText(event.target.value)} />;
  }
  return (
    <input
      {...common}
      type="text"
      placeholder={range}
      inputMode={isNumber ? "decimal" : "text"}
      maxLength={isNumber ? 40 : 120}
      autoComplete="off"
      onChange={(event) => onText(event.target.value)}
    />
  );
}

function choiceText(choice: string): string {
  if (choice === "dh-standard") return t("ui-denavit-hartenberg-standard");
  if (choice === "dh-modified") return t("ui-denavit-hartenberg-modified");
  if (choice === "u") return t("ui-from-left-to-right");
  if (choice === "v") return t("ui-from-top-to-bottom");
  if (choice === "1") return "+";
  return choice === "-1" ? "\u2212" : choice;
}
