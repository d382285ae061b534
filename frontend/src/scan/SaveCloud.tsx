import { useState } from "react";
import type { CloudFileFormat } from "../api/wire";
import look from "../parts/Control.module.css";
import { Download } from "../parts/Download";
import { t } from "../state/language";
import { useRead } from "../state/useRead";
import styles from "./SaveCloud.module.css";

/** Saves the cloud of a scan in any format of `crenel reconstruct`. */
export function SaveCloud({ id }: { id: string }) {
  const { value: formats } = useRead<CloudFileFormat[]>("/api/cloud-formats");
  const [suffix, setSuffix] = useState(".ply");
  const missing = formats?.find(({ why_not }) => why_not !== "");
  return (
    <>
      <div className={styles.save}>
        <Download href={`/api/scans/${encodeURIComponent(id)}/cloud${suffix}`}>{t("ui-save-the-cloud")}</Download>
        <select
          className={`${look.button} ${styles.format}`}
          aria-label={t("ui-file-format")}
          value={suffix}
          onChange={({ target }) => setSuffix(target.value)}
        >
          {(formats ?? [{ suffix: ".ply", why_not: "" }]).map((one) => (
            <option key={one.suffix} value={one.suffix} disabled={one.why_not !== ""}>
              {nameOf(one.suffix)}
            </option>
          ))}
        </select>
      </div>
      {missing && (
        <p className={styles.missing}>
          {nameOf(missing.suffix)}: {missing.why_not}
        </p>
      )}
    </>
  );
}

const nameOf = (suffix: string) => (suffix === ".copc.laz" ? "COPC" : suffix.slice(1).toUpperCase());
