import { sendCommand } from "../api/guideCommands";
import styles from "../controls/Field.module.css";
import { FileChooser } from "../controls/FileChooser";
import { t } from "../state/language";

const LONGEST_NAME = 80;

/** Takes a file of what a tracker or measuring machine measured into the identification. */
export function CoordinatesField({ points, disabled }: { points: number; disabled: boolean }) {
  const take = async ([file]: FileList) => {
    if (!file) return;
    const file_name = file.name.slice(-LONGEST_NAME);
    await sendCommand("arm", "take_coordinates", { text: await file.text(), file_name });
  };
  return (
    <div className={styles.field}>
      <label className={styles.label} htmlFor="coordinates-file">
        {points ? t("ui-coordinates-points-taken", { points }) : t("ui-coordinates-of-a-tracker")}
      </label>
      <FileChooser id="coordinates-file" accept=".csv,text/csv" disabled={disabled} onFiles={take}>
        {t("ui-choose-a-file")}
      </FileChooser>
    </div>
  );
}
