import type { DatasheetRow } from "../api/wire";
import { MainAct } from "../controls/Actions";
import { CardHead } from "../controls/CardHead";
import { FileChooser } from "../controls/FileChooser";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { t } from "../state/language";
import { go } from "../state/router";
import { useLive } from "../state/store";

interface DatasheetsCardProps {
  /** What was just saved. */
  saved: DatasheetRow | null;
  onCertify: (row: DatasheetRow) => void;
  onFiles: (files: FileList) => Promise<void>;
}

/** What the page is for, a file from this computer, and the way back to a calibration that waits for a choice. */
export function DatasheetsCard({ saved, onCertify, onFiles }: DatasheetsCardProps) {
  const choosing = useLive((s) => s.flow?.running === true && s.flow.picture.kind === "choices");
  return (
    <>
      {saved ? (
        <div role="status" data-verdict>
          <CardHead
            title={t("ui-the-datasheet-is-saved")}
            text={t("ui-saved-as", { name: saved.name || saved.file })}
          />
        </div>
      ) : (
        <CardHead title={t("ui-datasheets")} text={t("ui-what-datasheets-are")} />
      )}
      {choosing && (
        <MainAct>
          <PressButton free kind="primary" onPress={() => go("calibrate")}>
            {t("ui-back-to-the-calibration")}
          </PressButton>
        </MainAct>
      )}
      {saved?.form === "block" && !saved.certificate && (
        <>
          <PressButton free onPress={() => onCertify(saved)}>
            {t("ui-certify-this-block")}
          </PressButton>
          <p className={rows.detail}>{t("ui-why-certify")}</p>
        </>
      )}
      <FileChooser id="datasheet-file" accept=".json,.xml,application/json,text/xml" multiple onFiles={onFiles}>
        {t("ui-add-a-file")}
      </FileChooser>
      <p className={rows.detail}>{t("ui-files-can-be-dragged-in")}</p>
    </>
  );
}
