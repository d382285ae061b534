import type { AuditEntry } from "../api/accessTypes";
import { moment } from "../parts/format";
import { PressButton } from "../parts/PressButton";
import { said } from "../state/language";
import styles from "./Access.module.css";
import { useReread } from "./useReread";

/** Who did what, the newest first. */
export function AuditList() {
  const { list, reread } = useReread<AuditEntry>("/api/audit");
  return (
    <section className={styles.section} aria-label="Audit log">
      <div className={styles.head}>
        <h2 className={styles.title}>Who did what</h2>
        <PressButton free kind="quiet" onPress={reread}>
          Read again
        </PressButton>
      </div>
      <div className={styles.log}>
        <table className={styles.table}>
          <thead>
            <tr>
              <th scope="col">When</th>
              <th scope="col">Who</th>
              <th scope="col">What</th>
              <th scope="col">From</th>
            </tr>
          </thead>
          <tbody>
            {list?.map((entry) => (
              <tr key={entry.number} data-refused={entry.outcome !== "done" || undefined}>
                <td>{moment(entry.at)}</td>
                <td>{entry.who || "nobody signed in"}</td>
                <td>
                  {entry.act}
                  {entry.outcome !== "done" && <span className={styles.outcome}>not done: {said(entry.outcome)}</span>}
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
