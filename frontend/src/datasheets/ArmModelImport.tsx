import { type DragEvent, type ReactNode, useId, useState } from "react";

import type { ArmModelView, ModelQuestion } from "../api/wire";
import look from "../controls/Control.module.css";
import fields from "../controls/Field.module.css";
import { FileChooser } from "../controls/FileChooser";
import lists from "../controls/List.module.css";
import { typed, unitOf } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";
import styles from "./ArmModelImport.module.css";
import table from "./Datasheets.module.css";
import { readDatasheet } from "./upload";
import { useArmModel } from "./useArmModel";

const QUESTIONS: Record<ModelQuestion["key"], PlainId> = {
  columns: "ui-order-of-the-columns",
  length: "ui-unit-of-the-lengths",
  angle: "ui-unit-of-the-angles",
  convention: "ui-convention",
  end: "ui-the-arm-ends-at",
  base: "ui-the-arm-begins-at",
  robot: "ui-robot",
};
const OPTIONS: Record<string, PlainId> = {
  deg: "ui-degrees",
  rad: "ui-radians",
  inch: "ui-inches",
  "dh-standard": "ui-denavit-hartenberg-standard",
  "dh-modified": "ui-denavit-hartenberg-modified",
};

type Document = Record<string, unknown>;

interface ArmModelImportProps {
  /** The table that is filled in by hand. */
  children: ReactNode;
  onTake: (document: Document) => void;
}

/** The joints of an arm: entered by hand, or taken from a text or file that the station reads. */
export function ArmModelImport({ children, onTake }: ArmModelImportProps) {
  const [open, setOpen] = useState(false);
  if (open) return <ModelText onTake={onTake} onClose={() => setOpen(false)} />;
  return (
    <>
      <div className={styles.offer}>
        <PressButton free onPress={() => setOpen(true)}>
          {t("ui-take-the-model-from-a-text")}
        </PressButton>
      </div>
      {children}
    </>
  );
}

function ModelText({ onTake, onClose }: { onTake: (document: Document) => void; onClose: () => void }) {
  const { text, setText, answer, view } = useArmModel();
  const read = async (file: File | undefined) => {
    const found = file && (await readDatasheet(file));
    if (found) setText(found.text);
  };
  const drop = (event: DragEvent) => {
    if (event.dataTransfer.files.length === 0) return;
    event.preventDefault();
    void read(event.dataTransfer.files[0]);
  };
  return (
    <div className={styles.panel} onDragOver={(event) => event.preventDefault()} onDrop={drop}>
      <h2 className={styles.title}>{t("ui-the-model-as-its-maker-states-it")}</h2>
      <label className={fields.field}>
        <span className={fields.label}>{t("ui-text-of-the-model")}</span>
        <textarea
          className={`${look.input} ${fields.input} ${styles.text}`}
          rows={9}
          spellCheck={false}
          autoComplete="off"
          placeholder={"joint, a [mm], alpha [deg], d [mm], theta [deg]\n1, 0, 90, 162.5, 0\n…"}
          value={text}
          onChange={(event) => setText(event.target.value)}
        />
      </label>
      <div className={table.acts}>
        <FileChooser id="arm-model-file" free onFiles={([file]) => read(file)}>
          {t("ui-choose-a-file")}
        </FileChooser>
        <PressButton free kind="quiet" onPress={onClose}>
          {t("ui-back-to-the-table")}
        </PressButton>
      </div>
      {view && <Found view={view} onAnswer={answer} onTake={onTake} />}
    </div>
  );
}

/** What the station makes of the text: what it asks, and the joints once everything is answered. */
function Found({
  view,
  onAnswer,
  onTake,
}: {
  view: ArmModelView;
  onAnswer: (key: string, value: string) => void;
  onTake: (document: Document) => void;
}) {
  return (
    <>
      {view.source && <p className={styles.source}>{view.source}</p>}
      {view.problem && (
        <p className={table.problem} role="status">
          {view.problem}
        </p>
      )}
      {view.questions.map((question) => (
        <Question key={question.key} question={question} onAnswer={(value) => onAnswer(question.key, value)} />
      ))}
      {view.notes.map((note) => (
        <p key={note} className={lists.detail}>
          {note}
        </p>
      ))}
      {view.rows.length > 0 && (
        <>
          <ModelTable view={view} />
          <div className={table.acts}>
            <PressButton kind="primary" onPress={() => onTake(JSON.parse(view.document) as Document)}>
              {t("ui-this-is-the-arm-take-it-over")}
            </PressButton>
          </div>
        </>
      )}
    </>
  );
}

function Question({ question, onAnswer }: { question: ModelQuestion; onAnswer: (value: string) => void }) {
  const { key, options, answer, stated, likely, why } = question;
  const id = useId();
  return (
    <div className={fields.field} data-question={key}>
      <label className={fields.label} htmlFor={id}>
        {t(QUESTIONS[key])}
      </label>
      <select
        id={id}
        className={`${look.input} ${fields.input} ${styles.choice}`}
        aria-describedby={`${id}-note`}
        value={answer}
        disabled={stated}
        onChange={(event) => onAnswer(event.target.value)}
      >
        {!answer && <option value="">{t("ui-please-choose")}</option>}
        {options.map((option) => (
          <option key={option} value={option}>
            {optionText(option)}
          </option>
        ))}
      </select>
      <p id={`${id}-note`} className={lists.detail}>
        {stated && t("ui-the-text-says-so")}
        {!stated && likely && t("ui-likely-because", { option: optionText(likely), why })}
      </p>
    </div>
  );
}

const optionText = (option: string) => (OPTIONS[option] ? t(OPTIONS[option]) : option);

function ModelTable({ view }: { view: ArmModelView }) {
  const cells = (["a_mm", "alpha_deg", "d_mm", "theta_deg"] as const).map((key, i) => ({
    key,
    unit: i % 2 ? "°" : "mm",
  }));
  return (
    <div className={table.scroll}>
      <table className={styles.table} aria-label={t("ui-the-model-as-it-was-read")}>
        <thead>
          <tr>
            <th scope="col">{t("ui-joint-column")}</th>
            {[t("ui-joint-a"), t("ui-joint-alpha"), t("ui-joint-d"), t("ui-joint-theta")].map((head, i) => (
              <th key={head} scope="col">
                {head} <span>{unitOf(i % 2 ? "°" : "mm")}</span>
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {view.rows.map((row) => (
            <tr key={row.name}>
              <th scope="row">{row.name}</th>
              {cells.map(({ key, unit }) => (
                <td key={key}>{typed(Number(row[key].toPrecision(9)), unit)}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
