import look from "../controls/Control.module.css";
import fields from "../controls/Field.module.css";

interface ChoiceProps {
  label: string;
  value: string;
  options: { value: string; label: string }[];
  onChange: (value: string) => void;
}

/** One of a list that opens. */
export function Choice({ label, value, options, onChange }: ChoiceProps) {
  return (
    <label className={fields.field}>
      <span className={fields.label}>{label}</span>
      <select
        className={`${look.input} ${fields.input}`}
        value={value}
        onChange={(event) => onChange(event.target.value)}
      >
        {options.map((option) => (
          <option key={option.value} value={option.value}>
            {option.label}
          </option>
        ))}
      </select>
    </label>
  );
}
