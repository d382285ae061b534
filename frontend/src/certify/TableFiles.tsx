import type { DatasheetRow } from "../api/wire";
import { FileChooser } from "../controls/FileChooser";
import { LengthField } from "../controls/LengthField";
import lists from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { Choice } from "../design/Choice";
import { notify } from "../state/banner";
import { t } from "../state/language";
import styles from "./Certify.module.css";
import type { Draft } from "./draft";

/** The station takes 256 kB at once. */
const LARGEST_BYTES = 200_000;

/** Touches of faces, or distances of them, by the columns of the table. */
export async function readTable(file: File): Promise<Partial<Draft> | null> {
  const refuse = (title: string) => {
    notify({ quality: "attention", title });
    return null;
  };
  if (file.size > LARGEST_BYTES) return refuse(t("ui-table-is-too-large", { name: file.name }));
  try {
    const text = new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer());
    const table = { name: file.name, text };
    return /\bdistance_mm\b/.test(firstLine(text)) ? { table } : { points: table };
  } catch {
    return refuse(t("ui-table-is-not-utf-8", { name: file.name }));
  }
}

const firstLine = (text: string) => text.trimStart().split(/[\r\n]/, 1)[0] ?? "";

/** Whether points are joint angles, of which only the arm's model makes points. */
export const areJointAngles = (text: string) =>
  /\bq1_(deg|rad)\b/.test(firstLine(text)) && !/\bx_mm\b/.test(firstLine(text));

interface TableFilesProps {
  arms: DatasheetRow[];
  draft: Draft;
  onChange: (changes: Partial<Draft>) => void;
  onFiles: (files: FileList) => Promise<void>;
}

/** Tables of points and of readings, and the arm whose joint angles the points are. */
export function TableFiles({ arms, draft, onChange, onFiles }: TableFilesProps) {
  const shown = (["points", "table"] as const).filter((key) => draft[key]);
  return (
    <>
      {shown.map((key) => (
        <div key={key} className={styles.file} data-file={key}>
          <span>
            {t(key === "points" ? "ui-points-of-file" : "ui-readings-of-file", { name: draft[key]?.name ?? "" })}
          </span>
          <PressButton free kind="quiet" onPress={() => onChange({ [key]: null })}>
            {t("ui-leave-it-out")}
          </PressButton>
        </div>
      ))}
      <FileChooser id="table-files" accept=".csv,text/csv" multiple free onFiles={onFiles}>
        {t("ui-add-a-table")}
      </FileChooser>
      <p className={lists.detail}>{t("ui-what-tables-are")}</p>
      {draft.points && areJointAngles(draft.points.text) && (
        <>
          <Choice
            label={t("ui-arm")}
            value={draft.arm}
            options={[
              { value: "", label: t("ui-not-chosen") },
              ...arms.map(({ file, name, serial_number }) => ({
                value: file,
                label: [name || file, serial_number].filter(Boolean).join(", "),
              })),
            ]}
            onChange={(arm) => onChange({ arm })}
          />
          <div className={styles.readings}>
            <LengthField
              label={t("ui-optional-field", { label: t("ui-error-of-the-arm") })}
              detail={t("ui-else-as-identified")}
              unit="µm"
              value={draft.arm_um}
              needed={false}
              onText={(arm_um) => onChange({ arm_um })}
            />
            <LengthField
              label={t("ui-optional-field", { label: t("ui-uncertainty-of-the-tip") })}
              detail={t("ui-else-unknown")}
              unit="µm"
              value={draft.tip_um}
              needed={false}
              onText={(tip_um) => onChange({ tip_um })}
            />
          </div>
        </>
      )}
    </>
  );
}
