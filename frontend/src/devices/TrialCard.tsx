import type { Choice, Options } from "../api/deviceCommands";
import type { DevicesView, DriverForm, TrialView } from "../api/wire";
import { MainAct } from "../controls/Actions";
import { CardHead } from "../controls/CardHead";
import { PressButton } from "../controls/PressButton";
import { TextField } from "../controls/TextField";
import { t } from "../state/language";
import styles from "./Devices.module.css";
import { OptionFields } from "./OptionFields";

interface TrialCardProps {
  trial: TrialView;
  title: string;
  view: DevicesView;
  choice: Choice;
  label: string;
  onChoice: (choice: Choice) => void;
  onLabel: (label: string) => void;
  onTry: () => Promise<void>;
  onUse: () => Promise<void>;
  onBack: () => void;
}

const STATES = {
  opening: "ui-opening-the-device",
  live: "ui-is-this-the-right-device",
  waiting: "ui-connected-and-waiting-for-data",
  failed: "ui-the-device-could-not-be-opened",
  ended: "ui-the-trial-has-ended",
} as const;

/** The tried device: its name, its options, and the button that takes it. */
export function TrialCard(props: TrialCardProps) {
  const { trial, title, view, choice, label, onChoice, onLabel, onTry, onUse, onBack } = props;
  const form = formOf(view, choice);
  const changed = !sameOptions(choice.options, trial.options);
  const setOptions = (options: Options) => onChoice({ ...choice, options });
  const camera = choice.kind === "sensor";
  const used = view.devices.find((one) => one.kind === choice.kind);
  const renamed = used !== undefined && label.trim() !== used.label;
  const closed = trial.state === "failed" || trial.state === "ended";
  return (
    <>
      <CardHead title={title} text={t(STATES[trial.state])} />
      {trial.in_use && <p className={styles.note}>{t("ui-station-uses-it-already")}</p>}
      {trial.in_use ? (
        <MainAct>
          <PressButton kind="primary" disabled={!changed && !renamed} onPress={onUse}>
            {t("ui-save-changes")}
          </PressButton>
        </MainAct>
      ) : (
        <MainAct>
          <PressButton
            kind="primary"
            disabled={trial.state === "opening" || trial.state === "failed"}
            why={view.file ? "" : t("ui-devices-cannot-be-saved-here")}
            onPress={onUse}
          >
            {camera ? t("ui-use-this-camera") : t("ui-use-this-arm")}
          </PressButton>
        </MainAct>
      )}
      {(closed || (changed && !trial.in_use)) && (
        <PressButton free onPress={onTry}>
          {t("ui-try-again")}
        </PressButton>
      )}
      <div className={styles.fields}>
        <TextField
          label={t("ui-name-of-the-device")}
          help={t("ui-as-people-call-it-optional")}
          value={label}
          maxLength={60}
          onText={onLabel}
        />
        {form && (
          <OptionFields
            fields={form.fields}
            options={choice.options}
            offers={trial.offers}
            isMain={(field) => field.required || field.key in trial.options}
            onChange={setOptions}
          />
        )}
      </div>
      <div className={styles.foot}>
        <PressButton free kind="quiet" onPress={onBack}>
          {t("ui-back-to-the-list")}
        </PressButton>
      </div>
    </>
  );
}

export function formOf(view: DevicesView, { kind, driver }: Choice): DriverForm | undefined {
  return view.drivers.find((one) => one.kind === kind && one.name === driver);
}

/** Whether the fields say what the device was opened with. */
function sameOptions(fields: Options, opened: Options): boolean {
  const filled = Object.entries(fields).filter(([, value]) => value !== "");
  return (
    filled.length === Object.keys(opened).length &&
    filled.every(([key, value]) => String(opened[key]) === String(value).trim().replaceAll(", ", ","))
  );
}
