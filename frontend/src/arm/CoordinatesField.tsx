import { type ChangeEvent, useRef } from "react";

import { sendCommand } from "../api/guideCommands";
import styles from "../parts/Field.module.css";
import { PressButton } from "../parts/PressButton";
import { t } from "../state/language";

const LONGEST_NAME = 80;

/** Takes a file of what a tracker or measuring machine measured into the identification. */
export function CoordinatesField({ points, disabled }: { points: number; disabled: boolean }) {
  const chooser = useRef<HTMLInputElement>(null);
  const take = async (event: ChangeEvent<HTMLInputElement>) => {
    const field = event.currentTarget;
    const file = field.files?.[0];
    if (!file) return;
    const file_name = file.name.slice(-LONGEST_NAME);
    await sendCommand("arm", "take_coordinates", { text: await file.text(), file_name });
    // the same file can be chosen once more after it was corrected
    field.value = "";
  };
  return (
    <div className={styles.field}>
      <label className={styles.label} htmlFor="coordinates-file">
        {points ? t("ui-coordinates-points-taken", { points }) : t("ui-coordinates-of-a-tracker")}
      </label>
      <input ref={chooser} id="coordinates-file" type="file" accept=".csv,text/csv" hidden onChange={take} />
      <PressButton disabled={disabled} onPress={() => chooser.current?.click()}>
        {t("ui-choose-a-file")}
      </PressButton>
    </div>
  );
}
