import { type DragEvent, useState } from "react";

import type { DatasheetRow } from "../api/wire";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";
import styles from "./Datasheets.module.css";
import { FORMS, type FormName, formsOf, type Kind } from "./forms";
import { Row } from "./Row";

export const KINDS: readonly Kind[] = ["arm", "object", "sensor", "gauge"];
const TITLES: Record<Kind, PlainId> = {
  arm: "ui-arms",
  object: "ui-calibration-objects",
  sensor: "ui-sensors",
  gauge: "ui-gauges",
};
const NONE: Record<Kind, PlainId> = {
  arm: "ui-no-datasheet-of-an-arm",
  object: "ui-no-datasheet-of-an-object",
  sensor: "ui-no-datasheet-of-a-sensor",
  gauge: "ui-no-datasheet-of-a-gauge",
};

interface DatasheetListsProps {
  all: DatasheetRow[];
  /** The file that was just saved. */
  saved: string;
  onNew: (name: FormName) => void;
  onDesign: (what: "block" | "board") => void;
  onEdit: (row: DatasheetRow) => void;
  onCopy: (row: DatasheetRow) => void;
  onCertify: (row: DatasheetRow) => void;
  onRetire: (row: DatasheetRow) => Promise<void>;
  onRestore: (row: DatasheetRow) => Promise<void>;
  onFiles: (files: FileList) => Promise<void>;
}

/** Four lists of datasheets; files can be dragged onto them. */
export function DatasheetLists({ all, onFiles, ...acts }: DatasheetListsProps) {
  const [over, setOver] = useState(false);
  const drop = (event: DragEvent) => {
    event.preventDefault();
    setOver(false);
    void onFiles(event.dataTransfer.files);
  };
  const drag = (event: DragEvent) => {
    if (!event.dataTransfer.types.includes("Files")) return;
    event.preventDefault();
    setOver(true);
  };
  return (
    <div
      className={styles.lists}
      data-over={over || undefined}
      data-drop
      onDragOver={drag}
      onDragLeave={() => setOver(false)}
      onDrop={drop}
    >
      {KINDS.map((kind) => (
        <KindList key={kind} kind={kind} all={all.filter((row) => row.kind === kind)} {...acts} />
      ))}
    </div>
  );
}

function KindList({
  kind,
  all,
  saved,
  onNew,
  onDesign,
  ...acts
}: Omit<DatasheetListsProps, "onFiles"> & { kind: Kind }) {
  const [open, setOpen] = useState(false);
  const present = all.filter((row) => !row.retired);
  const retired = all.filter((row) => row.retired);
  const title = t(TITLES[kind]);
  const list = (some: DatasheetRow[]) => (
    <ul className={rows.list}>
      {some.map((row) => (
        <Row key={row.file} row={row} saved={!row.retired && row.file === saved} {...acts} />
      ))}
    </ul>
  );
  return (
    <section className={styles.kind} aria-label={title}>
      <h2 className={rows.heading}>{title}</h2>
      {present.length > 0 ? list(present) : <p className={rows.empty}>{t(NONE[kind])}</p>}
      <div className={styles.acts}>
        {formsOf(kind).map((name) => (
          <PressButton key={name} onPress={() => onNew(name)}>
            {t("ui-new-of-kind", { title: t(FORMS[name].title) })}
          </PressButton>
        ))}
        {kind === "object" && (
          <>
            <PressButton free onPress={() => onDesign("block")}>
              {t("ui-design-a-block")}
            </PressButton>
            <PressButton free onPress={() => onDesign("board")}>
              {t("ui-print-a-board")}
            </PressButton>
          </>
        )}
        {retired.length > 0 && (
          <PressButton free kind="quiet" onPress={() => setOpen(!open)}>
            {open ? t("ui-hide-the-retired-ones") : t("ui-show-retired-ones", { n: retired.length })}
          </PressButton>
        )}
      </div>
      {open && retired.length > 0 && list(retired)}
    </section>
  );
}
