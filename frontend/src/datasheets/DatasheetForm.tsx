import { useState } from "react";

import type { NewDatasheet } from "../api/datasheetCommands";
import type { ConnectedArmView } from "../api/wire";
import { MainAct } from "../controls/Actions";
import { CardHead } from "../controls/CardHead";
import lists from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { Segments } from "../controls/Segments";
import { Layout } from "../frame/Layout";
import { ObjectDrawing } from "../object/ObjectDrawing";
import { t } from "../state/language";
import { ArmModelImport } from "./ArmModelImport";
import { ArmPicture } from "./ArmPicture";
import styles from "./Datasheets.module.css";
import { drawn, drawnFlat } from "./drawn";
import { FieldInput } from "./FieldInput";
import { FlatDrawing } from "./FlatDrawing";
import { FORMS, type FormField, type FormName, type Values } from "./forms";
import { RowTable } from "./RowTable";
import { type Ranges, rangeText } from "./ranges";
import { useForm } from "./useForm";

/** The datasheet that is edited or copied. */
export interface Edited {
  /** Which takes its place; empty of a copy, which is a new one. */
  version: string;
  document: Record<string, unknown>;
}

interface DatasheetFormProps {
  name: FormName;
  first: Values;
  ranges: Ranges;
  arm: ConnectedArmView | null;
  edited?: Edited | undefined;
  onSave: (added: NewDatasheet) => Promise<void>;
  /** A model of the arm was read, which takes the place of the joints. */
  onModel: (values: Values, document: Record<string, unknown>) => void;
  onBack: () => void;
}

/** A datasheet that is entered or edited: checked by the station while typing, and drawn. */
export function DatasheetForm({ name, first, ranges, arm, edited, onSave, onModel, onBack }: DatasheetFormProps) {
  const form = useForm(name, first, edited?.document);
  const { kind, fields, title, table } = FORMS[name];
  const picture = useDrawing(name, form.document);
  const save = () => onSave({ name: "", text: form.text, edited: edited?.version ?? "" });
  const rangeOf = (field: FormField) => rangeText(name, field, ranges);
  const input = (field: FormField) => (
    <FieldInput
      key={field.key}
      field={field}
      value={form.values[field.key] ?? ""}
      range={rangeOf(field)}
      problem={form.problemOf(field.key)}
      onText={(text) => form.setValues({ ...form.values, [field.key]: text })}
    />
  );
  const rows = table && (
    <RowTable
      table={table}
      values={form.values}
      rangeOf={rangeOf}
      problemOf={form.problemOf}
      onValues={form.setValues}
    />
  );
  return (
    <Layout
      picture={
        kind === "arm" ? (
          <div className={styles.joints}>
            {name === "arm" ? (
              <ArmModelImport onTake={(document) => onModel(form.values, document)}>
                <ArmPicture document={form.document} arm={arm} />
                {rows}
              </ArmModelImport>
            ) : (
              <ArmPicture document={form.document} arm={arm} />
            )}
          </div>
        ) : (
          picture
        )
      }
      card={
        <>
          <CardHead
            title={t(title)}
            text={edited?.version ? t("ui-the-former-version-is-kept") : t("ui-as-its-certificate-says")}
          />
          <div className={styles.fields}>
            {fields.map((field) =>
              field.type === "list" ? (
                <div key={field.key} className={styles.edges}>
                  <Segments
                    wide
                    label={t("ui-edges-are-entered-as")}
                    value={form.asWidths ? "widths" : "edges"}
                    options={[
                      { value: "edges", label: t("ui-positions") },
                      { value: "widths", label: t("ui-widths") },
                    ]}
                    onChange={(as) => form.setAsWidths(as === "widths")}
                  />
                  {input(field)}
                  <p className={lists.detail}>
                    {form.asWidths ? t("ui-merlon-gap-merlon") : t("ui-left-to-right-two-for-each")}
                  </p>
                </div>
              ) : (
                input(field)
              ),
            )}
            {kind !== "arm" && rows}
          </div>
          <div className={styles.save}>
            {form.whole.map((words) => (
              <p key={words} className={styles.problem} role="status">
                {words}
              </p>
            ))}
            {form.note && (
              <p className={styles.notice} role="status">
                {form.note}
              </p>
            )}
            <MainAct>
              <PressButton kind="primary" disabled={!form.ready} why={why(form)} onPress={save}>
                {t("ui-save-the-datasheet")}
              </PressButton>
            </MainAct>
          </div>
          <div className={styles.foot}>
            <PressButton free kind="quiet" onPress={onBack}>
              {t("ui-back-to-the-list")}
            </PressButton>
          </div>
        </>
      }
    />
  );
}

/** Why it cannot be saved yet. */
function why({ filled, pending }: ReturnType<typeof useForm>): string {
  if (!filled) return t("ui-fill-in-the-fields");
  return pending ? t("ui-being-checked") : t("ui-correct-what-is-marked");
}

/** The thing as its numbers say; while they say nothing that can be drawn, as they said last. */
function useDrawing(name: FormName, document: Record<string, unknown>) {
  const object = drawn(name, document);
  const flat = drawnFlat(name, document);
  const [last, setLast] = useState({ object, flat });
  if ((object || flat) && JSON.stringify({ object, flat }) !== JSON.stringify(last)) setLast({ object, flat });
  if (!last.object && !last.flat) return <p className={styles.none}>{t("ui-drawing-follows-the-numbers")}</p>;
  const label = t("ui-drawing-of-the-datasheet");
  return (
    <div className={styles.drawing} data-stale={!(object || flat) || undefined}>
      {last.object && <ObjectDrawing object={last.object} face={null} label={label} />}
      {last.flat && <FlatDrawing shape={last.flat} label={label} />}
    </div>
  );
}
