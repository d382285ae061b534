import { startBackup } from "../api/watchCommands";
import type { BackupState } from "../api/wire";
import { Download } from "../controls/Download";
import { moment } from "../controls/format";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { Progress } from "../controls/Progress";
import { quantity } from "../messages/text";
import { t } from "../state/language";
import { pathOf } from "../state/router";
import styles from "./Health.module.css";

interface MaintenanceProps {
  backup: BackupState;
  admin: boolean;
  operator: boolean;
  onChange: () => Promise<void>;
}

/** Backups, and the support bundle. */
export function Maintenance({ backup, admin, operator, onChange }: MaintenanceProps) {
  const { last, share } = backup;
  const start = async () => {
    await startBackup();
    await onChange();
  };
  return (
    <>
      <section className={styles.section} aria-label={t("ui-backup")}>
        <h2 className={rows.heading}>{t("ui-backup")}</h2>
        <div className={styles.box}>
          <p>
            {last
              ? t("ui-last-backup", {
                  when: moment(last.at),
                  files: t("ui-files", { n: last.files }),
                  size: quantity(last.bytes / 1e6, "MB", 1),
                  folder: last.folder,
                })
              : t("ui-no-backup-yet", { folder: backup.folder })}
          </p>
          <p className={styles.help}>
            {t("ui-backup-copies-calibrations-scans-accounts-settings")} <code>crenel serve --data FOLDER</code>
          </p>
          {share !== null && <Progress done={Math.round(share * 100)} of={100} text={t("ui-copying")} />}
          {admin ? (
            <div className={styles.row}>
              <PressButton free disabled={share !== null} onPress={start}>
                {t("ui-back-up-now")}
              </PressButton>
            </div>
          ) : (
            <p className={styles.help}>{t("ui-only-an-administrator-can-make-backups")}</p>
          )}
        </div>
      </section>
      <section className={styles.section} aria-label={t("ui-http-interface")}>
        <h2 className={rows.heading}>{t("ui-http-interface")}</h2>
        <div className={styles.box}>
          <p>{t("ui-http-interface-explained")}</p>
          <p>
            <a href={pathOf("docs")}>{t("ui-open-the-reference")}</a>
          </p>
        </div>
      </section>
      {operator && (
        <section className={styles.section} aria-label={t("ui-support-bundle")}>
          <h2 className={rows.heading}>{t("ui-support-bundle")}</h2>
          <div className={styles.box}>
            <p>{t("ui-one-file-support-checks-versions-settings")}</p>
            <div className={styles.row}>
              <Download href="/api/support.zip">{t("ui-save-the-support-bundle")}</Download>
            </div>
          </div>
        </section>
      )}
    </>
  );
}
