import { LengthField } from "../controls/LengthField";
import lists from "../controls/List.module.css";
import { t } from "../state/language";
import styles from "./Certify.module.css";
import { type Dimension, dimensionsOf, type Instrument, keyOf, sdsOf } from "./dimensions";
import type { Draft } from "./draft";

interface ReadingFieldsProps {
  instrument: Instrument;
  edges: number;
  draft: Draft;
  onChange: (changes: Partial<Draft>) => void;
  onDimension: (dimension: Dimension) => void;
}

/** What an instrument reads: a field for each width and height, and what is known of the instrument. */
export function ReadingFields({ instrument, edges, draft, onChange, onDimension }: ReadingFieldsProps) {
  const { readings } = draft;
  const numbers = draft.numbers[instrument];
  // one of them alone may be right: both make the uncertainty of a reading
  const wrong = sdsOf(numbers) === null;
  const setNumber = (key: keyof typeof numbers) => (text: string) =>
    onChange({ numbers: { ...draft.numbers, [instrument]: { ...numbers, [key]: text } } });
  return (
    <>
      <div className={styles.readings}>
        <LengthField
          label={t("ui-resolution")}
          value={numbers.resolution}
          needed
          wrong={wrong}
          onText={setNumber("resolution")}
        />
        <LengthField
          label={t("ui-uncertainty-of-instrument")}
          value={numbers.uncertainty}
          needed
          wrong={wrong}
          onText={setNumber("uncertainty")}
        />
      </div>
      <p className={lists.detail}>{t("ui-uncertainty-counts-twice")}</p>
      <div className={styles.readings}>
        {dimensionsOf(edges, instrument).map((one) => (
          <LengthField
            key={keyOf(one)}
            label={one.optional ? t("ui-as-a-check", { label: one.label }) : one.label}
            detail={t("ui-from-face-to-face", { from: one.from, to: one.to })}
            value={readings[keyOf(one)] ?? ""}
            needed={false}
            onText={(text) => onChange({ readings: { ...readings, [keyOf(one)]: text } })}
            onFocus={() => onDimension(one)}
          />
        ))}
      </div>
    </>
  );
}
