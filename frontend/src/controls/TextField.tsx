import { type InputHTMLAttributes, useId } from "react";

import look from "./Control.module.css";
import styles from "./Field.module.css";

interface TextFieldProps extends Omit<InputHTMLAttributes<HTMLInputElement>, "onChange"> {
  label: string;
  help?: string;
  onText: (text: string) => void;
}

/** A line of text with its label above, large enough for a gloved finger. */
export function TextField({ label, help, onText, ...input }: TextFieldProps) {
  const id = useId();
  return (
    <div className={styles.field}>
      <label className={styles.label} htmlFor={id}>
        {label}
      </label>
      <input
        id={id}
        className={`${look.input} ${styles.input}`}
        type="text"
        aria-describedby={help ? `${id}-help` : undefined}
        {...input}
        onChange={(event) => onText(event.target.value)}
      />
      {help && (
        <p id={`${id}-help`} className={styles.help}>
          {help}
        </p>
      )}
    </div>
  );
}
