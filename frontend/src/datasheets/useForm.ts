import { useEffect, useState } from "react";

import { type CheckedDatasheet, checkDatasheet } from "../api/datasheetCommands";
import { useSettled } from "../controls/useSettled";
import { useBarred } from "../state/control";
import { render, t } from "../state/language";
import { documentOf, edgesOf, isFilled, placeOf } from "./document";
import { type FormField, type FormName, fieldsOf, type Values } from "./forms";
import { problemText } from "./wording";

interface Checked {
  text: string;
  check: CheckedDatasheet;
}

/** The fields of a form, and what the station says of them while they are filled in. */
export function useForm(name: FormName, first: Values, edited: Record<string, unknown> | undefined) {
  const [values, setValues] = useState(first);
  const [asWidths, setAsWidths] = useState(false);
  const document = documentOf(name, values, edited);
  if (asWidths && Array.isArray(document.edges_x_mm)) document.edges_x_mm = edgesOf(document.edges_x_mm);
  const text = JSON.stringify(document);
  const checked = useCheck(text);
  const fields = fieldsOf(name, values);
  const problems = (checked?.problems ?? [])
    .filter(({ missing }) => !missing)
    .map(({ field, text: said }) => {
      const place = placeOf(field, fields);
      const owner = fields.find(({ key }) => key === place);
      const words = problemText(said, name, owner);
      return { place, words: withPart(owner, field, words, asWidths) };
    });
  const filled = isFilled(name, values);
  return {
    values,
    setValues,
    asWidths,
    setAsWidths,
    document,
    text: `${JSON.stringify(document, null, 1)}\n`,
    filled,
    /** The station has not looked at it yet. */
    pending: checked === null,
    ready: filled && checked?.problems.length === 0,
    note: render(checked?.note ?? ""),
    problemOf: (key: string) => problems.find(({ place }) => place === key)?.words ?? "",
    /** What is wrong in the whole; said once everything is filled in. */
    whole: filled ? problems.filter(({ place }) => place === "").map(({ words }) => words) : [],
  };
}

/** The words with the place that they are about, where the label of the field does not say it. */
function withPart(owner: FormField | undefined, field: string, words: string, asWidths: boolean): string {
  if (!owner) return field ? t("ui-place-and-problem", { place: field, words }) : words;
  const part = owner.type === "list" ? Number(/\.(\d+)$/.exec(field)?.[1] ?? Number.NaN) : Number.NaN;
  // the first edge of widths is at 0, and was not typed
  return Number.isNaN(part)
    ? words
    : t("ui-place-and-problem", { place: t("ui-value-n", { n: part + (asWidths ? 0 : 1) }), words });
}

/** What the station says of a document; null until it has looked at this one. */
function useCheck(text: string): CheckedDatasheet | null {
  const barred = useBarred();
  const settled = useSettled(text);
  const [checked, setChecked] = useState<Checked | null>(null);
  useEffect(() => {
    let wanted = true;
    if (barred) return;
    checkDatasheet(settled).then(
      (check) => wanted && check && setChecked({ text: settled, check }),
      () => undefined, // the lost connection has its own banner
    );
    return () => {
      wanted = false;
    };
  }, [settled, barred]);
  return checked?.text === text ? checked.check : null;
}
