import { useId, useState } from "react";

import { sendCommand } from "../api/guideCommands";
import type { LineForm } from "../api/wire";
import look from "../controls/Control.module.css";
import fields from "../controls/Field.module.css";
import { unitOf } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { UnitInput } from "../controls/UnitInput";
import { useLengthField } from "../controls/useLengthField";
import type { PlainId } from "../messages/text";
import { LINE_CHOICES, type LineChoice } from "../settings/lineChoices";
import { t } from "../state/language";
import styles from "./LinePanel.module.css";

/** What the laser line is like, beside the picture in which it was not found. */
export function LinePanel({ line }: { line: LineForm }) {
  const threshold = useLengthField(line.threshold, t("ui-grey-levels"));
  const least = useLengthField(line.min_width_px, "px");
  const most = useLengthField(line.max_width_px, "px");
  const [choice, setChoice] = useState<LineChoice>(line.choice);
  const valid = [threshold, least, most].every((field) => field.valid);
  const id = useId();
  const set = () =>
    sendCommand("flow", line.action.name, {
      threshold: threshold.value,
      min_width_px: least.value,
      max_width_px: most.value,
      choice,
    });
  return (
    <section className={styles.panel} aria-labelledby={id}>
      <p id={id} className={styles.why}>
        {line.refused.length > 0
          ? t("ui-line-missing-in-poses", { poses: line.refused.join(", ") })
          : t("ui-line-found-in-all-poses")}
      </p>
      <div className={styles.fields}>
        <NumberField label="ui-threshold" unit={t("ui-grey-levels")} field={threshold} />
        <NumberField label="ui-minimum-width" unit="px" field={least} />
        <NumberField label="ui-maximum-width" unit="px" field={most} />
        <label className={fields.field}>
          <span className={fields.label}>{t("ui-where-several-lines-cross-a-column")}</span>
          <select
            className={`${look.input} ${fields.input}`}
            value={choice}
            onChange={(event) => setChoice(event.target.value as LineChoice)}
          >
            {LINE_CHOICES.map(({ value, label }) => (
              <option key={value} value={value}>
                {t(label)}
              </option>
            ))}
          </select>
        </label>
        <PressButton disabled={!valid || !line.action.enabled} why={line.action.why_not} onPress={set}>
          {line.action.label}
        </PressButton>
      </div>
      <p className={fields.help}>{t("ui-line-settings-stay-with-session")}</p>
    </section>
  );
}

interface NumberFieldProps {
  label: PlainId;
  unit: string;
  field: ReturnType<typeof useLengthField>;
}

/** A number of the line; an empty field means automatic. */
function NumberField({ label, unit, field }: NumberFieldProps) {
  const id = useId();
  return (
    <div className={fields.field}>
      <label className={fields.label} htmlFor={id}>
        {t(label)}
      </label>
      <UnitInput
        id={id}
        unit={unitOf(unit)}
        long={unit.length > 4}
        value={field.text}
        placeholder={t("ui-automatic-lowercase")}
        onText={field.setText}
      />
    </div>
  );
}
