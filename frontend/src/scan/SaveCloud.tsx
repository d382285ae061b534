import { useState } from "react";
import type { WritableFormat } from "../api/wire";
import look from "../controls/Control.module.css";
import { Download } from "../controls/Download";
import { t } from "../state/language";
import { useRead } from "../state/useRead";
import styles from "./SaveCloud.module.css";

/** Saves the cloud of a scan in any format of `crenel reconstruct`. */
export function SaveCloud({ id }: { id: string }) {
  const { value: formats } = useRead<WritableFormat[]>("/api/cloud-formats");
  const [form, setForm] = useState("ply");
  const missing = (formats ?? []).filter(({ why_not }) => why_not !== "");
  return (
    <>
      <div className={styles.save}>
        <Download href={`/api/scans/${encodeURIComponent(id)}/cloud.${form}`}>{t("ui-save-the-cloud")}</Download>
        <select
          className={`${look.button} ${styles.format}`}
          aria-label={t("ui-file-format")}
          value={form}
          onChange={({ target }) => setForm(target.value)}
        >
          {(formats ?? [{ form: "ply", why_not: "" }]).map((one) => (
            <option key={one.form} value={one.form} disabled={one.why_not !== ""}>
              {nameOf(one.form)}
            </option>
          ))}
        </select>
      </div>
      {missing.map((one) => (
        <p key={one.form} className={styles.missing}>
          {nameOf(one.form)}: {one.why_not}
        </p>
      ))}
    </>
  );
}

const nameOf = (form: string) => (form === "copc.laz" ? "COPC" : form.toUpperCase());
