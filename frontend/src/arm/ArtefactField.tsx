import { setValue } from "../api/guideCommands";
import type { Artefact } from "../api/wire";
import styles from "../controls/Field.module.css";
import { unitOf } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { Segments } from "../controls/Segments";
import { UnitInput } from "../controls/UnitInput";
import { useFieldForm } from "../controls/useFieldForm";
import { useLengthField } from "../controls/useLengthField";
import { t } from "../state/language";

const KINDS = [
  { value: "seat", label: "ui-seat" },
  { value: "bar", label: "ui-ball-bar" },
  { value: "sphere", label: "ui-sphere" },
] as const;
const SIZE = { bar: "ui-length-from-the-certificate", sphere: "ui-diameter-from-the-certificate" } as const;

/** What the tip is put to next, with the size that its certificate gives. */
export function ArtefactField({
  artefact,
  disabled,
  only = false,
}: {
  artefact: Artefact;
  disabled: boolean;
  only?: boolean;
}) {
  const { kind } = artefact;
  if (only && kind !== "seat") return <Size kind={kind} artefact={artefact} disabled={disabled} />;
  return (
    <div className={styles.field}>
      <span className={styles.label}>{t("ui-artefact")}</span>
      <Segments
        value={kind}
        onChange={(chosen) => void setValue("arm", "choose_artefact", { kind: chosen })}
        options={KINDS.map(({ value, label }) => ({ value, label: t(label) }))}
        disabled={disabled}
        wide
        label={t("ui-artefact")}
      />
      {kind !== "seat" && <Size key={kind} kind={kind} artefact={artefact} disabled={disabled} />}
    </div>
  );
}

interface SizeProps {
  kind: "bar" | "sphere";
  artefact: Artefact;
  disabled: boolean;
}

function Size({ kind, artefact, disabled }: SizeProps) {
  const size = useLengthField(artefact.size_mm, "mm");
  const uncertainty = useLengthField(artefact.standard_uncertainty_mm * 1000, "µm");
  const set = () =>
    setValue("arm", "choose_artefact", {
      kind,
      size_mm: size.value,
      standard_uncertainty_mm: kind === "bar" ? (uncertainty.value ?? 0) / 1000 : 0,
    });
  const { changed, valid, form } = useFieldForm([size, uncertainty], set);
  return (
    <form className={styles.field} {...form}>
      <label className={styles.label} htmlFor="artefact-size">
        {t(SIZE[kind])}
      </label>
      <div className={styles.row}>
        <UnitInput id="artefact-size" unit={unitOf("mm")} value={size.text} disabled={disabled} onText={size.setText} />
        {kind === "bar" && (
          <UnitInput
            unit={`${unitOf("µm")}, k = 1`}
            long
            aria-label={t("ui-standard-uncertainty-of-the-length")}
            value={uncertainty.text}
            disabled={disabled}
            onText={uncertainty.setText}
          />
        )}
        {changed && (
          <PressButton onPress={set} disabled={!valid}>
            {t("ui-set")}
          </PressButton>
        )}
        {/* without one the Enter key does nothing where there are two fields */}
        <input type="submit" hidden />
      </div>
    </form>
  );
}
