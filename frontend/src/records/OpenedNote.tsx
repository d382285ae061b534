import { continueRecord, openRecord } from "../api/recordCommands";
import { PressButton } from "../controls/PressButton";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { go } from "../state/router";
import { useLive } from "../state/store";
import styles from "./OpenedNote.module.css";

/** That the view shows a record, not what is scanned now; nothing while it is live. */
export function OpenedNote() {
  const opened = useLive((s) => s.library?.opened ?? null);
  if (!opened) return null;
  const close = async () => {
    if (await openRecord(opened.id, false)) go("scan");
  };
  return (
    <div className={styles.note} role="status">
      <p className={styles.words}>
        <strong>{t("ui-a-record-not-live")}</strong>
        {isolated(opened.name)}
      </p>
      <PressButton onPress={close}>{t("ui-back-to-live")}</PressButton>
    </div>
  );
}

/** That the next scans are added to a record; nothing if each is one of its own. */
export function ContinuedNote() {
  const continued = useLive((s) => s.library?.continued ?? null);
  if (!continued) return null;
  return (
    <div className={styles.note} role="status">
      <p className={styles.words}>
        <strong>{t("ui-next-scan-is-added-to")}</strong>
        {isolated(continued.name)} · {t("ui-n-scans", { n: continued.scans })}
      </p>
      <PressButton onPress={() => void continueRecord(continued.id, false)}>{t("ui-do-not-continue")}</PressButton>
    </div>
  );
}
