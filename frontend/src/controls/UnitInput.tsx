import type { InputHTMLAttributes } from "react";

import look from "./Control.module.css";
import fields from "./Field.module.css";
import { typedNumber } from "./lengths";
import styles from "./UnitInput.module.css";

interface UnitInputProps extends Omit<InputHTMLAttributes<HTMLInputElement>, "onChange" | "value"> {
  value: string;
  unit: string;
  /** The unit is wider than two letters. */
  long?: boolean;
  onText: (text: string) => void;
}

/** Characters that no number contains; comma and point are both decimal signs. */
const OTHER = /[^\d.,+\-\u2212e]/gi;

/** A typed number, followed by its unit. */
export function UnitInput({ value, unit, long = false, onText, ...input }: UnitInputProps) {
  const invalid = value.trim() !== "" && Number.isNaN(typedNumber(value));
  return (
    <div className={styles.unit} data-unit={unit}>
      <input
        className={`${look.input} ${fields.input}`}
        data-long={long || undefined}
        type="text"
        inputMode="decimal"
        autoComplete="off"
        value={value}
        aria-invalid={invalid || undefined}
        {...input}
        onChange={(event) => onText(event.target.value.replace(OTHER, ""))}
      />
    </div>
  );
}
