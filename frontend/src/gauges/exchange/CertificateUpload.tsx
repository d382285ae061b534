import { useState } from "react";

import { ask } from "../../api/commands";
import { post } from "../../api/http";
import type { ArtefactOption } from "../../api/wire";
import { FileChooser } from "../../controls/FileChooser";
import { notify } from "../../state/banner";
import { isolated } from "../../state/isolated";
import { t } from "../../state/language";
import styles from "./CertificateUpload.module.css";

/** Adds the digital certificate of a sphere to the station's gauges, and states what it is worth. */
export function CertificateUpload() {
  const [added, setAdded] = useState<ArtefactOption | null>(null);
  const take = async ([file]: FileList) => {
    if (!file) return;
    const text = await readText(file);
    if (text === null) {
      notify({ quality: "attention", title: t("ui-certificate-is-not-utf-8", { name: file.name }) });
      return;
    }
    const body = { name: file.name.slice(0, 200), text };
    const path = "/api/performance/certificate";
    setAdded(await ask(() => post<ArtefactOption>(path, body), t("ui-the-certificate-was-not-added")));
  };
  return (
    <div className={styles.upload}>
      <FileChooser id="certificate-file" accept=".xml,text/xml" onFiles={take}>
        {t("ui-add-a-certificate-dcc")}
      </FileChooser>
      {added && (
        <p className={styles.added} role="status">
          <strong>{isolated(added.label)}</strong>
          {added.detail && <span>{added.detail}</span>}
          <span>{added.why_not || t("ui-the-sphere-can-be-chosen")}</span>
        </p>
      )}
    </div>
  );
}

/** The text of a UTF-8 file; null of any other. */
async function readText(file: File): Promise<string | null> {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer());
  } catch {
    return null;
  }
}
