import { useEffect, useState } from "react";

import { checkDatasheet } from "../api/datasheetCommands";
import type { DatasheetCheck } from "../api/wire";
import { useSettled } from "../parts/useSettled";
import { useBarred } from "../state/control";
import { documentOf, edgesOf, isFilled, placeOf } from "./document";
import { type FormName, fieldsOf, type Values } from "./forms";

interface Checked {
  text: string;
  check: DatasheetCheck;
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
    .map(({ field, text: words }) => ({ place: placeOf(field, fields), words }));
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
    note: checked?.note ?? "",
    problemOf: (key: string) => problems.find(({ place }) => place === key)?.words ?? "",
    /** What is wrong in the whole; said once everything is filled in. */
    whole: filled ? problems.filter(({ place }) => place === "").map(({ words }) => words) : [],
  };
}

/** What the station says of a document; null until it has looked at this one. */
function useCheck(text: string): DatasheetCheck | null {
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
