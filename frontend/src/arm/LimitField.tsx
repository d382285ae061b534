import type { FormEvent } from "react";

import { sendCommand } from "../api/guideCommands";
import styles from "../parts/Field.module.css";
import { unitOf } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { UnitInput } from "../parts/UnitInput";
import { useLengthField } from "../parts/useLengthField";
import { t } from "../state/language";

/** The largest (max − min)/2 that the operator accepts; stored for the next checks. */
export function LimitField({ limit_um, tip }: { limit_um: number | null; tip: boolean }) {
  const limit = useLengthField(limit_um, "µm");
  const set = () => sendCommand("arm", "set_limit", { limit_um: limit.value });
  const submit = (event: FormEvent) => {
    event.preventDefault();
    if (limit.valid) void set();
  };
  return (
    <form className={styles.field} onSubmit={submit}>
      <label className={styles.label} htmlFor="arm-limit">
        {tip ? t("ui-limit-diameter-error-scatter") : t("ui-limit-max-min-2-axis")}
      </label>
      <div className={styles.row}>
        <UnitInput
          id="arm-limit"
          unit={unitOf("µm")}
          value={limit.text}
          placeholder={t("ui-none")}
          onText={limit.setText}
        />
        {limit.changed && (
          <PressButton onPress={set} disabled={!limit.valid}>
            {t("ui-set")}
          </PressButton>
        )}
      </div>
    </form>
  );
}
