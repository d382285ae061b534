import { useEffect, useRef, useState } from "react";
import { notifyOfError } from "../api/commands";
import {
  addDatasheet,
  DATASHEETS,
  fileOf,
  type NewDatasheet,
  restoreDatasheet,
  retireDatasheet,
} from "../api/datasheetCommands";
import { getFile } from "../api/http";
import type { Action, ConnectedArmView, DatasheetRow, DatasheetsView, Problem } from "../api/wire";
import { BlockCertifier } from "../certify/BlockCertifier";
import { CardHead } from "../controls/CardHead";
import { Question } from "../controls/Question";
import { DatasheetForm, type Edited } from "../datasheets/DatasheetForm";
import { DatasheetLists } from "../datasheets/DatasheetLists";
import { DatasheetsCard } from "../datasheets/DatasheetsCard";
import { copyOf, valuesOf, withModel } from "../datasheets/document";
import { FORMS, type FormName, firstRows, isForm, type Values } from "../datasheets/forms";
import { readDatasheet } from "../datasheets/upload";
import { BlockDesigner } from "../design/BlockDesigner";
import { BoardDesigner } from "../design/BoardDesigner";
import { Layout } from "../frame/Layout";
import { t } from "../state/language";
import { go, useDetail } from "../state/router";
import { useRead } from "../state/useRead";

const NEW = "new/";
const EDIT = "edit";
const CERTIFY = "certify/";
const DESIGN = { block: "design/block", board: "design/board" } as const;

interface Editing {
  name: FormName;
  first: Values;
  edited: Edited;
  /** Another one each time a model of an arm takes the place of the joints. */
  key: number;
}

/** Something that is done once the person agrees that another datasheet of the same thing is retired. */
interface Asked {
  words: string;
  agree: () => Promise<void>;
}

/** The datasheets of arms, sensors, objects and gauges: what is there, and what can be entered. */
export function DatasheetsPage() {
  const detail = useDetail();
  const [changes, setChanges] = useState(0);
  const { value: view } = useRead<DatasheetsView>(DATASHEETS, `${changes}`);
  const [editing, setEditing] = useState<Editing | null>(null);
  const [saved, setSaved] = useState<DatasheetRow | null>(null);
  const [asked, setAsked] = useState<Asked | null>(null);
  const edited = detail === EDIT ? editing : null; // the menu and the way back leave the form
  const created = detail.startsWith(NEW) ? detail.slice(NEW.length) : null;

  const here = useRef(true);
  useEffect(() => {
    here.current = true;
    return () => {
      here.current = false;
    };
  }, []);

  const list = () => {
    if (!here.current) return; // who went on while it was saved is not called back
    setEditing(null);
    setChanges((n) => n + 1);
    go("datasheets");
  };
  const keep = async (added: NewDatasheet, replace = false): Promise<boolean> => {
    const answer = await addDatasheet(added, replace);
    if (!answer) return false;
    if (isProblem(answer)) {
      const agree = async () => void (await keep(added, true));
      setAsked({ words: `${answer.detail} ${answer.remedy}`, agree });
      return false;
    }
    setSaved(answer);
    list();
    return true;
  };
  const certify = ({ version }: DatasheetRow) => {
    setSaved(null);
    go("datasheets", `${CERTIFY}${version}`);
  };
  const restore = async (row: DatasheetRow, replace = false): Promise<void> => {
    const answer = await restoreDatasheet(row, replace);
    if (answer && isProblem(answer)) {
      setAsked({ words: `${answer.detail} ${answer.remedy}`, agree: () => restore(row, true) });
    } else setChanges((n) => n + 1);
  };
  const edit = async (row: DatasheetRow, asCopy = false) => {
    if (!isForm(row.form)) return;
    setSaved(null);
    try {
      const present = JSON.parse(await (await getFile(fileOf(row))).text()) as Record<string, unknown>;
      const document = asCopy ? copyOf(present, t("ui-copy-of", { name: row.name })) : present;
      const version = asCopy ? "" : row.version;
      setEditing({ name: row.form, first: valuesOf(row.form, document), edited: { version, document }, key: 0 });
      go("datasheets", EDIT);
    } catch (error) {
      notifyOfError(error, t("ui-the-datasheet-was-not-changed"));
    }
  };
  const takeModel = (values: Values, document: Record<string, unknown>) => {
    setEditing({
      name: "arm",
      first: withModel(values, document),
      edited: { version: edited?.edited.version ?? "", document },
      key: (edited?.key ?? 0) + 1,
    });
    go("datasheets", EDIT);
  };
  const takeDesign = (name: FormName, document: Record<string, unknown>) => {
    setEditing({ name, first: valuesOf(name, document), edited: { version: "", document }, key: 0 });
    go("datasheets", EDIT);
  };
  const addFiles = async (files: FileList) => {
    setSaved(null);
    for (const file of Array.from(files)) {
      const added = await readDatasheet(file);
      if (added) await keep(added);
    }
  };

  const question = asked && <ReplaceQuestion asked={asked} onClose={() => setAsked(null)} />;
  if (!view) {
    return <Layout picture={null} card={<CardHead title={t("ui-datasheets")} text={t("ui-loading-the-list")} />} />;
  }
  if (edited) {
    return (
      <>
        <DatasheetForm
          {...edited}
          key={edited.key}
          ranges={view.ranges}
          arm={view.arm}
          onSave={async (added) => void (await keep(added))}
          onModel={takeModel}
          onBack={list}
        />
        {question}
      </>
    );
  }
  if (isForm(created)) {
    return (
      <>
        <DatasheetForm
          key={created}
          name={created}
          first={firstValues(created, view.arm)}
          ranges={view.ranges}
          arm={view.arm}
          onSave={async (added) => void (await keep(added))}
          onModel={takeModel}
          onBack={list}
        />
        {question}
      </>
    );
  }
  const measured = view.rows.find((row) => isBlockInUse(row) && detail === `${CERTIFY}${row.version}`);
  if (measured) {
    return (
      <>
        <BlockCertifier
          key={measured.version}
          row={measured}
          arms={view.rows.filter(({ form, retired }) => form === "arm" && !retired)}
          onSave={(text) => keep({ name: "", text, edited: measured.version })}
          onBack={list}
        />
        {question}
      </>
    );
  }
  if (detail === DESIGN.block) {
    return <BlockDesigner rows={view.rows} onTake={(document) => takeDesign("block", document)} onBack={list} />;
  }
  if (detail === DESIGN.board) return <BoardDesigner onTake={takeDesign} onBack={list} />;
  return (
    <>
      <Layout
        picture={
          <DatasheetLists
            all={view.rows}
            saved={saved?.file ?? ""}
            onNew={(name) => {
              setSaved(null);
              go("datasheets", `${NEW}${name}`);
            }}
            onDesign={(what) => {
              setSaved(null);
              go("datasheets", DESIGN[what]);
            }}
            onEdit={(row) => void edit(row)}
            onCopy={(row) => void edit(row, true)}
            onCertify={certify}
            onRetire={async (row) => {
              await retireDatasheet(row);
              setChanges((n) => n + 1);
            }}
            onRestore={restore}
            onFiles={addFiles}
          />
        }
        card={<DatasheetsCard saved={saved} onCertify={certify} onFiles={addFiles} />}
      />
      {question}
    </>
  );
}

const isBlockInUse = ({ form, retired }: DatasheetRow) => form === "block" && !retired;

const isProblem = (answer: object): answer is Problem => "status" in answer;

/** What a new form begins with: of an arm, what is known of the connected one. */
function firstValues(name: FormName, arm: ConnectedArmView | null): Values {
  const { kind, first, table } = FORMS[name];
  if (kind !== "arm" || !arm || (name === "arm") !== arm.joint_count > 0) return first;
  const known = { name: arm.name, serial_number: arm.serial_number };
  return table ? { convention: "dh-standard", ...firstRows(table, arm.joint_count), ...known } : known;
}

function ReplaceQuestion({ asked, onClose }: { asked: Asked; onClose: () => void }) {
  const replace: Action = {
    name: "replace",
    label: t("ui-replace-it"),
    args: {},
    primary: false,
    enabled: true,
    why_not: "",
    confirm: asked.words,
  };
  return <Question opened action={replace} no={t("ui-no-keep-it")} onClose={onClose} onAct={asked.agree} />;
}
