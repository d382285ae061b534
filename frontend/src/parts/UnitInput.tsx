import type { InputHTMLAttributes } from "react";

import look from "./Control.module.css";
import fields from "./Field.module.css";
import styles from "./UnitInput.module.css";

interface UnitInputProps extends Omit<InputHTMLAttributes<HTMLInputElement>, "onChange"> {
  unit: string;
  /** The unit takes more room than two letters. */
  long?: boolean;
  onText: (text: string) => void;
}

/** A number typed in, with its unit behind it. */
export function UnitInput({ unit, long = false, onText, ...input }: UnitInputProps) {
  return (
    <div className={styles.unit} data-unit={unit}>
      <input
        className={`${look.input} ${fields.input}`}
        data-long={long || undefined}
        type="number"
        inputMode="decimal"
        step="any"
        {...input}
        onChange={(event) => onText(event.target.value)}
      />
    </div>
  );
}
