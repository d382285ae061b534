import { type FormEvent, useState } from "react";

import { tell } from "../api/commands";
import { post } from "../api/http";
import fields from "../parts/Field.module.css";
import { figures } from "../parts/format";
import { PressButton } from "../parts/PressButton";
import { UnitInput } from "../parts/UnitInput";
import { t } from "../state/language";
import styles from "./TemperatureField.module.css";

/** The room's temperature: what is known of it, and a place to tell it. */
export function TemperatureField({ celsius }: { celsius: number | null }) {
  const [text, setText] = useState("");
  const set = async () => {
    try {
      await post("/api/temperature", { celsius: Number(text.replace(",", ".")) });
      setText("");
    } catch (error) {
      tell(error, t("the temperature was not kept"));
    }
  };
  const submit = (event: FormEvent) => {
    event.preventDefault();
    if (text) void set();
  };
  return (
    <form className={styles.field} onSubmit={submit}>
      <label className={fields.label} htmlFor="room-temperature">
        {t("Room temperature")}: {celsius === null ? t("not known") : <strong>{figures(celsius, 1)} °C</strong>}
      </label>
      <div className={fields.row}>
        <UnitInput id="room-temperature" unit="°C" min={-20} max={60} value={text} placeholder={celsius === null ? t("tell it") : t("now")} onText={setText} />
        {text !== "" && <PressButton onPress={set}>{t("Set")}</PressButton>}
      </div>
    </form>
  );
}
