import { sendArm } from "../api/armCommands";
import type { ChoiceOption } from "../api/types";
import look from "../parts/Control.module.css";
import styles from "../parts/Field.module.css";
import { t } from "../state/language";
import { isolated } from "../state/isolated";

/** Which of the station's arms is checked. */
export function ArmChoice({ arms, arm }: { arms: ChoiceOption[]; arm: string }) {
  return (
    <label className={styles.field}>
      <span className={styles.label}>{t("Arm")}</span>
      <select
        className={`${look.input} ${styles.input}`}
        value={arm}
        onChange={(event) => void sendArm("choose_arm", { id: event.target.value })}
      >
        {!arm && <option value="">{t("Choose the arm")}</option>}
        {arms.map((option) => (
          <option key={option.id} value={option.id}>
            {isolated(option.label)}, {option.detail}
          </option>
        ))}
      </select>
    </label>
  );
}
