import { Modal } from "@mantine/core";
import { useState } from "react";

import { nameNextPart } from "../api/recordCommands";
import type { NewPart, PartNames } from "../api/wire";
import { PressButton } from "../controls/PressButton";
import { TextField } from "../controls/TextField";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./PartForm.module.css";
import { partOf } from "./ScanRow";

const FIELDS: [keyof PartNames, PlainId][] = [
  ["part", "ui-part"],
  ["serial_number", "ui-serial-number"],
  ["order", "ui-order"],
  ["customer", "ui-customer"],
];

interface PartFormProps {
  title: string;
  part: PartNames;
  onSave: (part: NewPart) => Promise<boolean>;
  onClose: () => void;
}

/** Names a part: what it is, which one, and for whom. */
export function PartForm({ title, part, onSave, onClose }: PartFormProps) {
  const [names, setNames] = useState<NewPart>({ ...part });
  const save = async () => {
    if (await onSave(names)) onClose();
  };
  return (
    <Modal opened onClose={onClose} title={title} centered radius="md" size="lg">
      <form
        className={styles.form}
        onSubmit={(event) => {
          event.preventDefault();
          void save();
        }}
      >
        {FIELDS.map(([field, label]) => (
          <TextField
            key={field}
            label={t(label)}
            value={names[field] ?? ""}
            maxLength={120}
            onText={(text) => setNames({ ...names, [field]: text })}
          />
        ))}
        <div className={styles.answers}>
          <PressButton kind="quiet" free onPress={onClose}>
            {t("ui-cancel")}
          </PressButton>
          <PressButton kind="primary" onPress={save}>
            {t("ui-save")}
          </PressButton>
        </div>
      </form>
    </Modal>
  );
}

/** The part of the scan that runs, or of the next one, and how to name it. */
export function NextPart() {
  const part = useLive((s) => s.library?.part ?? null);
  const [naming, setNaming] = useState(false);
  if (!part) return null;
  const words = partOf(part);
  return (
    <div className={styles.line}>
      <p className={words ? styles.words : styles.unnamed}>{words || t("ui-the-part-is-not-named")}</p>
      <PressButton onPress={() => setNaming(true)}>{t("ui-name-part")}</PressButton>
      {naming && (
        <PartForm
          title={t("ui-part-of-next-scans")}
          part={part}
          onSave={nameNextPart}
          onClose={() => setNaming(false)}
        />
      )}
    </div>
  );
}
