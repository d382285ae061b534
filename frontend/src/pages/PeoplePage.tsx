import { Accounts } from "../access/Accounts";
import { AuditList } from "../access/AuditList";
import { Walls } from "../access/Walls";
import { Banners } from "../frame/Banners";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./RecordsPage.module.css";

/** Who may do what at this station, and who did what. */
export function PeoplePage() {
  const role = useLive((s) => s.session?.you?.role);
  return (
    <main className={styles.page}>
      <div className={styles.records}>
        {role === "admin" ? (
          <>
            <Accounts />
            <Walls />
            <AuditList />
          </>
        ) : (
          <p className={styles.empty}>{t("Accounts are an administrator’s affair.")}</p>
        )}
      </div>
      <Banners />
    </main>
  );
}
