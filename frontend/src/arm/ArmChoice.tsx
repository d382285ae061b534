import { setValue } from "../api/guideCommands";
import type { ChoiceOption } from "../api/wire";
import look from "../controls/Control.module.css";
import styles from "../controls/Field.module.css";
import { isolated } from "../state/isolated";
import { t } from "../state/language";

/** Which of the station's arms is checked. */
export function ArmChoice({ arms, arm }: { arms: ChoiceOption[]; arm: string }) {
  return (
    <label className={styles.field}>
      <span className={styles.label}>{t("ui-arm")}</span>
      <select
        className={`${look.input} ${styles.input}`}
        value={arm}
        onChange={(event) => void setValue("arm", "choose_arm", { id: event.target.value })}
      >
        {!arm && <option value="">{t("ui-choose-the-arm")}</option>}
        {arms.map((option) => (
          <option key={option.id} value={option.id}>
            {isolated(option.label)}, {option.detail}
          </option>
        ))}
      </select>
    </label>
  );
}
