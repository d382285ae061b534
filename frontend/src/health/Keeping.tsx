import type { BackupState } from "../api/watchTypes";
import { startBackup } from "../api/watchCommands";
import { Download } from "../parts/Download";
import { figures, moment } from "../parts/format";
import { PressButton } from "../parts/PressButton";
import { Progress } from "../parts/Progress";
import { counted, t } from "../state/language";
import styles from "./Health.module.css";

interface KeepingProps {
  backup: BackupState;
  admin: boolean;
  operator: boolean;
  onChange: () => Promise<void>;
}

/** Copies of everything, and what to send to whoever helps. */
export function Keeping({ backup, admin, operator, onChange }: KeepingProps) {
  const { last, share } = backup;
  const start = async () => {
    await startBackup();
    await onChange();
  };
  return (
    <>
      <section className={styles.section} aria-label={t("Backup")}>
        <h2 className={styles.title}>{t("Backup")}</h2>
        <div className={styles.box}>
          <p>
            {last
              ? t("The last was made {when}: {files}, {size} MB in {folder}", {
                  when: moment(last.at),
                  files: counted(last.files, "{n} file", "{n} files"),
                  size: figures(last.bytes / 1e6, 1),
                  folder: last.folder,
                })
              : t("There is none yet. Backups go to {folder}", { folder: backup.folder })}
          </p>
          <p className={styles.help}>
            {t("It copies calibrations, scans, accounts and settings while the station runs on. To go back to it, stop the station and start it with that folder:")}{" "}
            <code>crenel serve --data FOLDER</code>
          </p>
          {share !== null && <Progress done={Math.round(share * 100)} of={100} text={t("Copying")} />}
          {admin ? (
            <div className={styles.row}>
              <PressButton free disabled={share !== null} onPress={start}>
                {t("Make a backup now")}
              </PressButton>
            </div>
          ) : (
            <p className={styles.help}>{t("An administrator makes backups.")}</p>
          )}
        </div>
      </section>
      {operator && (
        <section className={styles.section} aria-label={t("Support bundle")}>
          <h2 className={styles.title}>{t("Support bundle")}</h2>
          <div className={styles.box}>
            <p>
              {t("One file for whoever helps you: checks, versions, settings, the log and the last steps. Passwords, tokens, keys and names are left out; nothing is sent anywhere.")}
            </p>
            <div className={styles.row}>
              <Download href="/api/support.zip">{t("Save the support bundle")}</Download>
            </div>
          </div>
        </section>
      )}
    </>
  );
}
