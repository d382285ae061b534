import { useState } from "react";

import type { AuditEntry } from "../api/accessTypes";
import { moment } from "../parts/format";
import { PressButton } from "../parts/PressButton";
import { TextField } from "../parts/TextField";
import { useSettled } from "../parts/useSettled";
import { isolated, withIsolated } from "../state/isolated";
import { said, t, useLanguage } from "../state/language";
import styles from "./Access.module.css";
import { useReread } from "./useReread";

/** Who did what, the newest first. */
export function AuditList() {
  const [words, setWords] = useState("");
  const settled = useSettled(words);
  const language = useLanguage();
  const { list, reread } = useReread<AuditEntry>(`/api/audit?words=${encodeURIComponent(settled)}&lang=${language}`);
  return (
    <section className={styles.section} aria-label={t("Audit log")}>
      <h2 className={styles.title}>{t("Who did what")}</h2>
      <div className={styles.line}>
        <TextField label={t("Words in it")} value={words} maxLength={100} onText={setWords} />
        <PressButton free kind="quiet" onPress={reread}>
          {t("Read again")}
        </PressButton>
      </div>
      <div className={styles.log} tabIndex={0}>
        <table className={styles.table}>
          <thead>
            <tr>
              <th scope="col">{t("When")}</th>
              <th scope="col">{t("Who")}</th>
              <th scope="col">{t("What")}</th>
              <th scope="col">{t("From")}</th>
            </tr>
          </thead>
          <tbody>
            {list?.length === 0 && (
              <tr>
                <td colSpan={4}>{t("Nothing that was done is like that.")}</td>
              </tr>
            )}
            {list?.map((entry) => (
              <tr key={entry.number} data-refused={entry.outcome !== "done" || undefined}>
                <td>{moment(entry.at)}</td>
                <td>{isolated(entry.who) || t("nobody signed in")}</td>
                <td>
                  {withIsolated(entry.act)}
                  {entry.outcome !== "done" && <span className={styles.outcome}>{t("not done: {reason}", { reason: said(entry.outcome) })}</span>}
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
