import { type ReactNode, useId } from "react";

import { setValue } from "../../api/guideCommands";
import type { PerformanceView } from "../../api/wire";
import { PressButton } from "../../controls/PressButton";
import { UnitInput } from "../../controls/UnitInput";
import { useFieldForm } from "../../controls/useFieldForm";
import { useLengthField } from "../../controls/useLengthField";
import { t } from "../../state/language";
import { KINDS } from "../kinds";
import styles from "./ArtefactChoice.module.css";

interface Props {
  view: PerformanceView;
  /** At the end of the test; the uncertainty is then known. */
  end?: boolean;
}

/**
 * The temperatures of artefact and arm: sizes and lengths are brought to 20 °C by the first, whose
 * uncertainty counts in them.
 */
export function Temperatures({ view, end = false }: Props) {
  const { artefact_c, arm_c, expanded_c } = view.picture;
  const { sized } = KINDS[view.test];
  const why = sized ? "ui-temperatures-why" : "ui-temperatures-why-of-a-plane";
  const artefact = useLengthField(artefact_c, "°C");
  const uncertainty = useLengthField(artefact_c === null ? null : expanded_c, "°C");
  const arm = useLengthField(arm_c, "°C");
  const fields = [artefact, arm, ...(end || !sized ? [] : [uncertainty])];
  const set = () =>
    setValue("performance", "set_temperature", {
      celsius: artefact.value,
      arm_c: arm.value,
      expanded_c: artefact.value === null ? 0 : (uncertainty.value ?? 0),
    });
  const { changed, valid, form } = useFieldForm(fields, set);
  return (
    <section>
      <h3 className={styles.heading}>{end ? t("ui-temperatures-at-the-end") : t("ui-temperatures")}</h3>
      <p className={styles.text}>{end ? t("ui-temperatures-at-the-end-why") : t(why)}</p>
      <form className={styles.limits} {...form}>
        <Row title={t("ui-temperature-of-the-artefact")}>
          {(id) => (
            <>
              <Degrees id={id} field={artefact} placeholder={t("ui-none")} />
              {!end && sized && (
                <div className={styles.number}>
                  <span aria-hidden="true">±</span>
                  <Degrees field={uncertainty} placeholder="0" label={t("ui-temperature-uncertainty")} />
                </div>
              )}
            </>
          )}
        </Row>
        <Row title={t("ui-temperature-of-the-arm")}>
          {(id) => <Degrees id={id} field={arm} placeholder={t("ui-none")} />}
        </Row>
        {changed && (
          <div className={styles.limit}>
            <PressButton onPress={set} disabled={!valid}>
              {t("ui-set")}
            </PressButton>
          </div>
        )}
      </form>
    </section>
  );
}

function Row({ title, children }: { title: string; children: (id: string) => ReactNode }) {
  const id = useId();
  return (
    <div className={styles.limit}>
      <label htmlFor={id} className={styles.what}>
        {title}
      </label>
      <div className={styles.numbers}>{children(id)}</div>
    </div>
  );
}

interface DegreesProps {
  field: { text: string; setText: (text: string) => void };
  placeholder: string;
  id?: string;
  label?: string;
}

function Degrees({ field, placeholder, id, label }: DegreesProps) {
  return (
    <UnitInput
      id={id}
      unit="°C"
      value={field.text}
      placeholder={placeholder}
      aria-label={label}
      onText={field.setText}
    />
  );
}
