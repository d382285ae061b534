/** What the station says of a document in the words of a form. */

import { typed, unitOf } from "../controls/lengths";
import { isMessage, isMessageList, message, type Text, type Value } from "../messages/text";
import { render, t } from "../state/language";
import { FORMS, type FormField, type FormName } from "./forms";

/** How the station names a field in a text. */
const FIELD_NAME = "field-name";
/** What a number must be, less or more than it. */
const LIMIT = "limit";

/** A problem as it stands in a form: fields by their labels, a limit as it would be typed. */
export function problemText(text: Text, name: FormName, field?: FormField): string {
  return render(reworded(text, name, field));
}

function reworded(text: Text, name: FormName, field?: FormField): Text {
  if (typeof text === "string") return text;
  if (isMessageList(text)) return { ...text, items: text.items.map((item) => reworded(item, name, field)) };
  if (!isMessage(text)) return text;
  const { message_id, values } = text;
  if (message_id === FIELD_NAME) return named(String(values.name), name);
  const now = Object.entries(values).map(([place, value]): [string, Value] => {
    if (place === LIMIT && field?.type === "number" && typeof value === "string") return [place, limit(value, field)];
    return [place, typeof value === "number" ? value : reworded(value, name, field)];
  });
  return { message_id, values: Object.fromEntries(now) };
}

/** A field by its label; one that the form does not have, as in the file. */
function named(key: string, name: FormName): Text {
  const { fields, table, parts } = FORMS[name];
  const label = [...fields, ...(table?.columns ?? [])].find((field) => field.key === key)?.label ?? parts?.[key];
  return label ? message("ui-named-field", { label: t(label) }) : key;
}

function limit(value: string, { unit = "", scale = 1 }: FormField): string {
  const shown = typed(Number(value) / scale, unit);
  return unit ? `${shown}\u00a0${unitOf(unit)}` : shown;
}
