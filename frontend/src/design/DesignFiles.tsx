import { done } from "../api/commands";
import { DownloadIcon } from "../controls/icons";
import { PressButton } from "../controls/PressButton";
import { saveFile } from "../controls/saveFile";
import { t } from "../state/language";
import styles from "./Design.module.css";

/** A file that a design can be had as. */
export interface DesignFile {
  label: string;
  /** Of the saved file. */
  name: string;
  make: () => Promise<Blob>;
  /** What is missing before it can be had. */
  whyNot?: string;
}

/** Files of a design, each on its button; what is missing for one stands below. */
export function DesignFiles({ files, disabled }: { files: DesignFile[]; disabled: boolean }) {
  const missing = files.filter(({ whyNot }) => whyNot);
  return (
    <>
      <div className={styles.files}>
        {files.map(({ label, name, make, whyNot = "" }) => (
          <PressButton
            free
            key={name}
            disabled={disabled || whyNot !== ""}
            describedBy={whyNot ? `why-no-${name}` : undefined}
            onPress={async () => {
              await done(async () => saveFile(await make(), name), t("ui-nothing-was-exported"));
            }}
          >
            <DownloadIcon size="1.25rem" />
            {label}
          </PressButton>
        ))}
      </div>
      {missing.map(({ name, label, whyNot }) => (
        <p key={name} id={`why-no-${name}`}>
          {t("ui-place-and-problem", { place: label, words: whyNot ?? "" })}
        </p>
      ))}
    </>
  );
}

/** A document as a file. */
export const jsonFile = async (document: string) => new Blob([document], { type: "application/json" });
