import { useId } from "react";

import fields from "./Field.module.css";
import { fromTyped, unitOf } from "./lengths";
import { UnitInput } from "./UnitInput";

interface LengthFieldProps {
  label: string;
  /** More about it, below its label. */
  detail?: string;
  value: string;
  /** Marked while nothing is typed. */
  needed: boolean;
  /** Marked, though it is a length above zero. */
  wrong?: boolean;
  unit?: string;
  onText: (text: string) => void;
  onFocus?: () => void;
}

/** The station takes no length beyond. */
const MOST = 1e6;

/** Whether what is typed is a length that the station takes. */
export function isLength(text: string, unit = "mm"): boolean {
  const value = fromTyped(text, unit);
  return value > 0 && value <= MOST;
}

/** A length above zero, with its label. */
export function LengthField({ label, detail, value, needed, wrong, unit = "mm", onText, onFocus }: LengthFieldProps) {
  const id = useId();
  return (
    <div className={fields.field}>
      <label className={fields.label} htmlFor={id}>
        {label}
        {detail && <span className={fields.detail}>{detail}</span>}
      </label>
      <div className={fields.row}>
        <UnitInput
          id={id}
          value={value}
          unit={unitOf(unit)}
          aria-invalid={wrong || ((needed || value !== "") && !isLength(value, unit)) || undefined}
          onText={onText}
          onFocus={onFocus}
        />
      </div>
    </div>
  );
}
