import { useId } from "react";

import fields from "../controls/Field.module.css";
import { fromTyped, roundTyped, unitOf } from "../controls/lengths";
import { UnitInput } from "../controls/UnitInput";
import styles from "./Design.module.css";

/** A number between two ends of a slider; what is typed may lie beyond them. */
export interface SliderRange {
  unit: string;
  low: number;
  high: number;
  /** What the station takes at least and at most. */
  least: number;
  most: number;
}

interface NumberSliderProps extends SliderRange {
  label: string;
  value: string;
  /** What an empty field stands for. */
  proposed?: string;
  onText: (text: string) => void;
}

const STEPS = 200;

/** Whether a typed number can be sent. */
export function isWithin(text: string, { unit, least, most }: SliderRange): boolean {
  const value = fromTyped(text, unit);
  return value >= least && value <= most;
}

/** A number that is typed or pushed; each step of the slider changes it by the same share. */
export function NumberSlider({ label, value, proposed, onText, ...range }: NumberSliderProps) {
  const id = useId();
  const { unit, low, high } = range;
  const shown = value === "" && proposed !== undefined ? proposed : value;
  const now = fromTyped(shown, unit);
  const span = Math.log(high / low);
  const place = Number.isFinite(now) && now > 0 ? Math.round((STEPS * Math.log(now / low)) / span) : 0;
  return (
    <div className={fields.field}>
      <label className={fields.label} htmlFor={id}>
        {label}
      </label>
      <div className={styles.number}>
        <input
          type="range"
          className={styles.slider}
          aria-label={label}
          aria-valuetext={`${shown} ${unitOf(unit)}`}
          min={0}
          max={STEPS}
          value={place}
          onChange={(event) => {
            const pushed = low * Math.exp((span * Number(event.target.value)) / STEPS);
            onText(roundTyped(pushed, unit, pushed < 10 ? 2 : 3));
          }}
        />
        <UnitInput
          id={id}
          value={value}
          unit={unitOf(unit)}
          placeholder={proposed}
          aria-invalid={!(isWithin(value, range) || (proposed !== undefined && value === "")) || undefined}
          onText={onText}
        />
      </div>
    </div>
  );
}
