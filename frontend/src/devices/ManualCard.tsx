import { useId } from "react";

import type { Choice } from "../api/deviceCommands";
import type { DevicesView } from "../api/wire";
import { MainAct } from "../controls/Actions";
import { CardHead } from "../controls/CardHead";
import look from "../controls/Control.module.css";
import fields from "../controls/Field.module.css";
import { PressButton } from "../controls/PressButton";
import { t } from "../state/language";
import styles from "./Devices.module.css";
import { driversOf, manualTitle } from "./names";
import { OptionFields } from "./OptionFields";
import { formOf } from "./TrialCard";

interface ManualCardProps {
  view: DevicesView;
  choice: Choice;
  onChoice: (choice: Choice) => void;
  onTry: () => Promise<void>;
  onBack: () => void;
}

/** A device that no search finds: its driver, and its address. */
export function ManualCard({ view, choice, onChoice, onTry, onBack }: ManualCardProps) {
  const id = useId();
  const form = formOf(view, choice);
  const drivers = driversOf(view, choice.kind);
  const missing = (form?.fields ?? []).some((one) => one.required && !String(choice.options[one.key] ?? "").trim());
  return (
    <>
      {/* below the list, it would not be seen on a small screen */}
      <div data-verdict>
        <CardHead title={manualTitle(choice.kind)} text={t("ui-choose-how-it-is-connected")} />
      </div>
      <div className={styles.fields}>
        <div className={fields.field}>
          <label className={fields.label} htmlFor={id}>
            {t("ui-connection")}
          </label>
          <select
            id={id}
            className={`${look.input} ${fields.input}`}
            value={choice.driver}
            onChange={(event) => onChoice({ ...choice, driver: event.target.value, options: {} })}
          >
            {drivers.map((one) => (
              <option key={one.name} value={one.name}>
                {one.title}
              </option>
            ))}
          </select>
        </div>
        {form?.problem && <p className={styles.failure}>{form.problem}</p>}
        {form && (
          <OptionFields
            key={form.name}
            fields={form.fields}
            options={choice.options}
            offers={[]}
            isMain={(field) => field.main}
            onChange={(options) => onChoice({ ...choice, options })}
          />
        )}
      </div>
      <MainAct>
        <PressButton free kind="primary" disabled={missing} why={t("ui-fill-in-what-is-needed")} onPress={onTry}>
          {t("ui-try-this-device")}
        </PressButton>
      </MainAct>
      <div className={styles.foot}>
        <PressButton free kind="quiet" onPress={onBack}>
          {t("ui-back-to-the-list")}
        </PressButton>
      </div>
    </>
  );
}
