import { useState } from "react";

import { done } from "../../api/commands";
import { getFile } from "../../api/http";
import type { ExportFormats } from "../../api/wire";
import { Download } from "../../controls/Download";
import { DownloadIcon } from "../../controls/icons";
import { PressButton } from "../../controls/PressButton";
import { saveFile } from "../../controls/saveFile";
import { t } from "../../state/language";
import { useRead } from "../../state/useRead";
import { CertificateForm, type Issuer } from "./CertificateForm";
import styles from "./ExportFiles.module.css";

/** The result of a performance test for other programs. */
export function ExportFiles({ id }: { id: string }) {
  const { value: formats } = useRead<ExportFormats>("/api/export-formats");
  const [issuing, setIssuing] = useState(false);
  const workbookMissing = formats?.xlsx_why_not ?? "";
  const save = async (form: string, ending: string, query = "") => {
    const path = `/api/performances/${id}/export.${form}${query}`;
    await done(async () => saveFile(await getFile(path), `performance-${id}${ending}`), t("ui-nothing-was-exported"));
  };
  const issue = (issuer: Issuer) => save("dcc", "-dcc.xml", `?${new URLSearchParams({ ...issuer })}`);
  return (
    <div className={styles.files}>
      <Save label="CSV" onPress={() => save("zip", ".zip")} />
      <Save label="XLSX" onPress={() => save("xlsx", ".xlsx")} disabled={workbookMissing !== ""} />
      <Save label="QIF" onPress={() => save("qif", ".qif")} />
      <Save label="DCC" onPress={() => setIssuing(true)} />
      <Download href={`/api/performances/${id}`}>JSON</Download>
      {workbookMissing && (
        <p id="workbook-missing" className={styles.why}>
          XLSX: {workbookMissing}
        </p>
      )}
      <CertificateForm opened={issuing} onClose={() => setIssuing(false)} onIssue={issue} />
    </div>
  );
}

function Save({ label, onPress, disabled = false }: SaveProps) {
  return (
    <PressButton free onPress={onPress} disabled={disabled} describedBy={disabled ? "workbook-missing" : undefined}>
      <DownloadIcon size="1.25rem" />
      {label}
    </PressButton>
  );
}

interface SaveProps {
  label: string;
  onPress: () => Promise<void> | void;
  disabled?: boolean;
}
