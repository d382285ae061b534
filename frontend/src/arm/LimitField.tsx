import type { FormEvent } from "react";

import { sendArm } from "../api/armCommands";
import styles from "../parts/Field.module.css";
import { typed, unitOf } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { UnitInput } from "../parts/UnitInput";
import { useHeldLength } from "../parts/useHeldLength";
import { t } from "../state/language";

/** The largest (max − min)/2 that the operator accepts; kept for the next checks. */
export function LimitField({ limit_um, tip }: { limit_um: number | null; tip: boolean }) {
  const limit = useHeldLength(limit_um, "µm");
  const set = () => sendArm("set_limit", { limit_um: limit.value });
  const submit = (event: FormEvent) => {
    event.preventDefault();
    void set();
  };
  return (
    <form className={styles.field} onSubmit={submit}>
      <label className={styles.label} htmlFor="arm-limit">
        {tip ? t("Limit of the diameter's error and of the scatter") : t("Limit of (max − min)/2 on each axis")}
      </label>
      <div className={styles.row}>
        <UnitInput
          id="arm-limit"
          unit={unitOf("µm")}
          min={typed(1, "µm")}
          max={typed(100000, "µm")}
          value={limit.text}
          placeholder={t("none")}
          onText={limit.setText}
        />
        {limit.changed && <PressButton onPress={set}>{t("Set")}</PressButton>}
      </div>
    </form>
  );
}
