import { useState } from "react";

import type { AuditEntry } from "../api/wire";
import { moment } from "../controls/format";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { TextField } from "../controls/TextField";
import { useSettled } from "../controls/useSettled";
import { isolated, withIsolated } from "../state/isolated";
import { t, useLanguage } from "../state/language";
import styles from "./Access.module.css";
import { useReread } from "./useReread";

/** Who did what, the newest first. */
export function AuditList() {
  const [words, setWords] = useState("");
  const settled = useSettled(words);
  const language = useLanguage();
  const { list, reread } = useReread<AuditEntry>(`/api/audit?words=${encodeURIComponent(settled)}&lang=${language}`);
  return (
    <section className={styles.section} aria-label={t("ui-audit-log")}>
      <h2 className={rows.heading}>{t("ui-actions-by-user")}</h2>
      <div className={styles.line}>
        <TextField label={t("ui-search-text")} value={words} maxLength={100} onText={setWords} />
        <PressButton free kind="quiet" onPress={reread}>
          {t("ui-reload")}
        </PressButton>
      </div>
      <div className={styles.log}>
        <table className={styles.table}>
          <thead>
            <tr>
              <th scope="col">{t("ui-when")}</th>
              <th scope="col">{t("ui-who")}</th>
              <th scope="col">{t("ui-what")}</th>
              <th scope="col">{t("ui-from")}</th>
            </tr>
          </thead>
          <tbody>
            {list?.length === 0 && (
              <tr>
                <td colSpan={4}>{t("ui-no-entry-matches")}</td>
              </tr>
            )}
            {list?.map((entry) => (
              <tr key={entry.number} data-refused={entry.outcome !== "done" || undefined}>
                <td>{moment(entry.at)}</td>
                <td>{isolated(entry.who) || t("ui-not-signed-in")}</td>
                <td>
                  {withIsolated(entry.act)}
                  {entry.outcome !== "done" && (
                    <span className={styles.outcome}>{t("ui-not-done", { reason: entry.outcome })}</span>
                  )}
                </td>
                <td>{entry.address}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </section>
  );
}
