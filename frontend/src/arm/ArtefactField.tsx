import type { FocusEvent, FormEvent } from "react";

import { sendArm } from "../api/armCommands";
import type { Artefact } from "../api/armTypes";
import styles from "../parts/Field.module.css";
import { Segments } from "../parts/Segments";
import { unitOf } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { UnitInput } from "../parts/UnitInput";
import { useHeldLength } from "../parts/useHeldLength";
import { t, words } from "../state/language";

const KINDS = [
  { value: "seat", label: words("Seat") },
  { value: "bar", label: words("Ball bar") },
  { value: "sphere", label: words("Sphere") },
];
const SIZE = { bar: words("Length by its certificate"), sphere: words("Diameter by its certificate") };

/** What the tip is put to next, with the size that its certificate gives. */
export function ArtefactField({ artefact, disabled, only = false }: { artefact: Artefact; disabled: boolean; only?: boolean }) {
  const { kind } = artefact;
  if (only && kind !== "seat") return <Size kind={kind} artefact={artefact} disabled={disabled} />;
  return (
    <div className={styles.field}>
      <span className={styles.label}>{t("What the tip is put to")}</span>
      <Segments
        value={kind}
        onChange={(chosen) => void sendArm("choose_artefact", { kind: chosen })}
        options={KINDS.map(({ value, label }) => ({ value, label: t(label) }))}
        disabled={disabled}
        wide
        label={t("What the tip is put to")}
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
  const size = useHeldLength(artefact.size_mm, "mm");
  const unsure = useHeldLength(artefact.standard_uncertainty_mm * 1000, "µm");
  const set = () =>
    sendArm("choose_artefact", {
      kind,
      size_mm: size.value,
      standard_uncertainty_mm: kind === "bar" ? (unsure.value ?? 0) / 1000 : 0,
    });
  const submit = (event: FormEvent) => {
    event.preventDefault();
    void set();
  };
  const changed = size.changed || unsure.changed;
  // what stands in the field counts, whichever button is pressed next
  const leave = ({ currentTarget, relatedTarget }: FocusEvent) => {
    if (changed && !currentTarget.contains(relatedTarget)) void set();
  };
  return (
    <form className={styles.field} onSubmit={submit} onBlur={leave}>
      <label className={styles.label} htmlFor="artefact-size">
        {t(SIZE[kind])}
      </label>
      <div className={styles.row}>
        <UnitInput id="artefact-size" unit={unitOf("mm")} value={size.text} disabled={disabled} onText={size.setText} />
        {kind === "bar" && (
          <UnitInput
            unit={`${unitOf("µm")}, k = 1`}
            long
            min={0}
            aria-label={t("Standard uncertainty of the length")}
            value={unsure.text}
            disabled={disabled}
            onText={unsure.setText}
          />
        )}
        {changed && <PressButton onPress={set}>{t("Set")}</PressButton>}
        {/* without one the Enter key does nothing where there are two fields */}
        <input type="submit" hidden />
      </div>
    </form>
  );
}
