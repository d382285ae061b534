import { Accounts } from "../access/Accounts";
import { AuditList } from "../access/AuditList";
import { KioskLinks } from "../access/KioskLinks";
import rows from "../controls/List.module.css";
import { Banners } from "../frame/Banners";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./RecordsPage.module.css";

/** Accounts and the audit log. */
export function PeoplePage() {
  const role = useLive((s) => s.session?.you?.role);
  return (
    <main className={styles.page}>
      <div className={styles.records} tabIndex={0}>
        {role === "admin" ? (
          <>
            <Accounts />
            <KioskLinks />
            <AuditList />
          </>
        ) : (
          <p className={rows.empty}>{t("ui-only-an-administrator-can-manage-accounts")}</p>
        )}
      </div>
      <Banners />
    </main>
  );
}
