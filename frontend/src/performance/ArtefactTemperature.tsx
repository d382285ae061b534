import type { FormEvent } from "react";

import { sendCommand } from "../api/guideCommands";
import { PressButton } from "../parts/PressButton";
import { UnitInput } from "../parts/UnitInput";
import { useLengthField } from "../parts/useLengthField";
import { t } from "../state/language";
import styles from "./ArtefactChoice.module.css";

interface Props {
  celsius: number | null;
  /** k = 2 */
  expanded: number;
}

/** The temperature of the artefact, by which sizes and lengths are brought to 20 °C. */
export function ArtefactTemperature({ celsius, expanded }: Props) {
  const measured = useLengthField(celsius, "°C");
  const uncertainty = useLengthField(celsius === null ? null : expanded, "°C");
  const valid = measured.valid && uncertainty.valid;
  const set = () =>
    sendCommand("performance", "set_temperature", {
      celsius: measured.value,
      expanded_c: measured.value === null ? 0 : (uncertainty.value ?? 0),
    });
  const submit = (event: FormEvent) => {
    event.preventDefault();
    if (valid) void set();
  };
  return (
    <section>
      <h3 className={styles.heading}>{t("ui-temperature-of-the-artefact")}</h3>
      <p className={styles.text}>{t("ui-temperature-of-the-artefact-why")}</p>
      <form className={styles.limit} onSubmit={submit}>
        <div className={styles.numbers}>
          <div className={styles.number}>
            <UnitInput
              unit="°C"
              value={measured.text}
              placeholder={t("ui-none")}
              aria-label={t("ui-temperature-of-the-artefact")}
              onText={measured.setText}
            />
          </div>
          <div className={styles.number}>
            <span aria-hidden="true">±</span>
            <UnitInput
              unit="°C"
              value={uncertainty.text}
              placeholder="0"
              aria-label={t("ui-temperature-uncertainty")}
              onText={uncertainty.setText}
            />
          </div>
        </div>
        {(measured.changed || uncertainty.changed) && (
          <PressButton onPress={set} disabled={!valid}>
            {t("ui-set")}
          </PressButton>
        )}
      </form>
    </section>
  );
}
