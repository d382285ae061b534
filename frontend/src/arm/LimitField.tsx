import { setValue } from "../api/guideCommands";
import styles from "../controls/Field.module.css";
import { unitOf } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { UnitInput } from "../controls/UnitInput";
import { useFieldForm } from "../controls/useFieldForm";
import { useLengthField } from "../controls/useLengthField";
import { t } from "../state/language";

/** The largest (max − min)/2 that the operator accepts; stored for the next checks. */
export function LimitField({ limit_um, tip }: { limit_um: number | null; tip: boolean }) {
  const limit = useLengthField(limit_um, "µm");
  const set = () => setValue("arm", "set_limit", { limit_um: limit.value });
  const { changed, valid, form } = useFieldForm([limit], set);
  return (
    <form className={styles.field} {...form}>
      <label className={styles.label} htmlFor="arm-limit">
        {tip ? t("ui-limit-diameter-error-scatter") : t("ui-limit-max-min-2-axis")}
      </label>
      <div className={styles.row}>
        <UnitInput
          id="arm-limit"
          unit={unitOf("µm")}
          value={limit.text}
          placeholder={t("ui-limit-none")}
          onText={limit.setText}
        />
        {changed && (
          <PressButton onPress={set} disabled={!valid}>
            {t("ui-set")}
          </PressButton>
        )}
      </div>
    </form>
  );
}
