import { addressOf } from "../state/base";
import { currentLanguage, t } from "../state/language";
import look from "./Control.module.css";
import download from "./Download.module.css";
import { DownloadIcon } from "./icons";
import styles from "./Reports.module.css";

/** A record's report: to read in a tab of its own, and as PDF. */
export function Reports({ of }: { of: string }) {
  const lang = currentLanguage() === "en" ? "" : `?lang=${currentLanguage()}`;
  return (
    <div className={styles.reports}>
      <a
        className={`${look.button} ${download.download}`}
        href={addressOf(`${of}/report.html${lang}`)}
        target="_blank"
        rel="noopener"
      >
        {t("ui-report")}
      </a>
      <a
        className={`${look.button} ${download.download}`}
        href={addressOf(`${of}/report.pdf${lang}`)}
        target="_blank"
        rel="noopener"
      >
        <DownloadIcon size="1.25rem" />
        PDF
      </a>
    </div>
  );
}
