import { useState } from "react";

import { ask } from "../api/commands";
import { sendCommand, setValue } from "../api/guideCommands";
import { post } from "../api/http";
import type { PartView } from "../api/wire";
import { FileChooser } from "../controls/FileChooser";
import { PressButton } from "../controls/PressButton";
import { TextField } from "../controls/TextField";
import { useFieldForm } from "../controls/useFieldForm";
import { ChoiceGroup } from "../flow/ChoiceGroup";
import { notify } from "../state/banner";
import { t } from "../state/language";
import { putView } from "../state/store";
import styles from "./SetupForm.module.css";

const LONGEST_NAME = 120;

/** What is measured, of which part, by whom. */
export function SetupForm({ view }: { view: PartView }) {
  return (
    <div className={styles.setup}>
      {view.programs.length > 0 && (
        <ChoiceGroup
          title={t("ui-part-program")}
          options={view.programs}
          selected={view.program}
          onChoose={(id) => void setValue("parts", "choose_program", { id })}
        />
      )}
      <FileChooser id="program-file" accept=".json,application/json" onFiles={takeProgram}>
        {t("ui-part-add-program")}
      </FileChooser>
      <Names key={view.session_id} view={view} />
    </div>
  );
}

function Names({ view }: { view: PartView }) {
  const [serial, setSerial] = useState(view.serial_number);
  const [operator, setOperator] = useState(view.operator);
  const changed = serial !== view.serial_number || operator !== view.operator;
  const set = async () => setValue("parts", "name_part", { serial_number: serial, operator });
  const { form } = useFieldForm([{ changed, valid: true }], set);
  return (
    <form className={styles.names} aria-label={t("ui-part-names")} {...form}>
      <TextField label={t("ui-part-serial-number")} value={serial} maxLength={200} onText={setSerial} />
      <TextField label={t("ui-part-operator")} value={operator} maxLength={200} onText={setOperator} />
      {view.calibration && <p className={styles.calibration}>{t("ui-part-calibration", { name: view.calibration })}</p>}
    </form>
  );
}

async function takeProgram([file]: FileList): Promise<void> {
  if (!file) return;
  const text = await readText(file);
  if (text === null) {
    notify({ quality: "attention", title: t("ui-part-program-is-not-text", { name: file.name }) });
    return;
  }
  const body = { name: file.name.slice(-LONGEST_NAME), text };
  const view = await ask(() => post<PartView>("/api/parts/programs", body), t("ui-part-program-was-not-added"));
  if (view) putView("parts", view);
}

/** The text of a UTF-8 file; null of any other. */
async function readText(file: File): Promise<string | null> {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer());
  } catch {
    return null;
  }
}

/** Skips a feature with the reason that is typed. */
export function SkipForm({ feature, onDone }: { feature: string; onDone: () => void }) {
  const [reason, setReason] = useState("");
  const why = reason.trim();
  const skip = async () => {
    await sendCommand("parts", "skip_feature", { id: feature, reason: why });
    onDone();
  };
  const { form } = useFieldForm([{ changed: false, valid: why !== "" }], skip);
  return (
    <form className={styles.skip} {...form}>
      <TextField label={t("ui-part-why-skip", { feature })} value={reason} maxLength={200} onText={setReason} />
      <PressButton disabled={why === ""} onPress={skip}>
        {t("ui-part-skip-it", { feature })}
      </PressButton>
    </form>
  );
}
