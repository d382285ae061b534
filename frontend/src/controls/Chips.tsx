import styles from "./Chips.module.css";

interface ChipsProps<T> {
  label: string;
  /** `lang` if a label is in that language; `mark` is a word that says why one is marked. */
  options: { value: T; label: string; lang?: string; mark?: string | undefined }[];
  value: T;
  onChange: (value: T) => void;
  id?: string;
}

/** A choice of one among a few, large enough for gloves; nothing if there is no choice. */
export function Chips<T extends string | number>({ label, options, value, onChange, id }: ChipsProps<T>) {
  if (options.length < 2) return null;
  return (
    <div id={id} className={styles.chips} role="group" aria-label={label}>
      {options.map((option) => (
        <button
          key={option.value}
          type="button"
          className={styles.chip}
          aria-pressed={option.value === value}
          aria-label={option.mark && `${option.label}, ${option.mark}`}
          title={option.mark}
          lang={option.lang}
          onClick={() => onChange(option.value)}
        >
          {option.label}
          {option.mark && <span className={styles.mark} />}
        </button>
      ))}
    </div>
  );
}
