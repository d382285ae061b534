import { useState } from "react";
import { deleteScan, renameScan } from "../api/viewCommands";
import type { Action, ScanSummary } from "../api/wire";
import look from "../controls/Control.module.css";
import { PressButton } from "../controls/PressButton";
import { Question } from "../controls/Question";
import { t } from "../state/language";
import styles from "./ScanActs.module.css";

interface ScanActsProps {
  scan: ScanSummary;
  onDeleted?: () => void;
}

/** Renames or deletes a scan; deleting asks for confirmation. */
export function ScanActs({ scan, onDeleted }: ScanActsProps) {
  const [renaming, setRenaming] = useState(false);
  const [asking, setAsking] = useState(false);
  const end: Action = {
    name: "delete",
    label: t("ui-delete"),
    args: {},
    primary: false,
    enabled: true,
    why_not: "",
    confirm: t("ui-delete-recording-points-removed-disk-permanently", {
      name: scan.name,
      points: scan.points,
    }),
  };
  if (renaming) return <NewName scan={scan} onDone={() => setRenaming(false)} />;
  return (
    <div className={styles.acts}>
      <PressButton kind="quiet" onPress={() => setRenaming(true)}>
        {t("ui-rename")}
      </PressButton>
      <PressButton kind="quiet" onPress={() => setAsking(true)}>
        {t("ui-delete")}
      </PressButton>
      <Question
        action={end}
        no={t("ui-no-keep-it")}
        opened={asking}
        onClose={() => setAsking(false)}
        onAct={async () => {
          if (await deleteScan(scan.id)) onDeleted?.();
        }}
      />
    </div>
  );
}

function NewName({ scan, onDone }: { scan: ScanSummary; onDone: () => void }) {
  const [name, setName] = useState(scan.name);
  const empty = name.trim() === "";
  const save = async () => {
    if (!empty && (name === scan.name || (await renameScan(scan.id, name)))) onDone();
  };
  return (
    <form
      className={styles.naming}
      onSubmit={(event) => {
        event.preventDefault();
        void save();
      }}
    >
      <input
        className={`${look.input} ${styles.input}`}
        value={name}
        maxLength={120}
        autoFocus
        aria-label={t("ui-new-name-of", { name: scan.name })}
        onFocus={(event) => event.currentTarget.select()}
        onChange={(event) => setName(event.target.value)}
        onKeyDown={(event) => event.key === "Escape" && onDone()}
      />
      <PressButton onPress={save} disabled={empty}>
        {t("ui-save")}
      </PressButton>
      <PressButton kind="quiet" free onPress={onDone}>
        {t("ui-cancel")}
      </PressButton>
    </form>
  );
}
