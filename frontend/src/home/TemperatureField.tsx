import { type FormEvent, useState } from "react";

import { notifyOfError } from "../api/commands";
import { post } from "../api/http";
import fields from "../controls/Field.module.css";
import { measured, typedNumber } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { UnitInput } from "../controls/UnitInput";
import { t } from "../state/language";
import styles from "./TemperatureField.module.css";

/** The ambient temperature, and a field to enter it. */
export function TemperatureField({ celsius }: { celsius: number | null }) {
  const [text, setText] = useState("");
  const value = typedNumber(text);
  const valid = !Number.isNaN(value);
  const set = async () => {
    try {
      await post("/api/temperature", { celsius: value });
      setText("");
    } catch (error) {
      notifyOfError(error, t("ui-the-temperature-was-not-saved"));
    }
  };
  const submit = (event: FormEvent) => {
    event.preventDefault();
    if (valid) void set();
  };
  return (
    <form className={styles.field} onSubmit={submit}>
      <label className={fields.label} htmlFor="ambient-temperature">
        {t("ui-ambient-temperature")}:{" "}
        {celsius === null ? t("ui-unknown") : <strong>{measured(celsius, "°C", 1)}</strong>}
      </label>
      <div className={fields.row}>
        <UnitInput
          id="ambient-temperature"
          unit="°C"
          value={text}
          placeholder={celsius === null ? t("ui-enter-it") : t("ui-now")}
          onText={setText}
        />
        {text !== "" && (
          <PressButton onPress={set} disabled={!valid}>
            {t("ui-set")}
          </PressButton>
        )}
      </div>
    </form>
  );
}
