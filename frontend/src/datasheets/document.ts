/** Between the fields of a form and the document that is kept. */

import { fromTyped, typed } from "../controls/lengths";
import { FORMS, type FormField, type FormName, fieldsOf, rowCount, type Values } from "./forms";

type Plain = Record<string, unknown>;

/** Numbers of a list: separated by spaces, semicolons or lines, or by commas that are no decimal signs. */
const SEPARATORS = /[\s;]+|,(?=[-\u2212+])|,\s+/;

export function listed(text: string): string[] {
  return text
    .split(SEPARATORS)
    .map((part) => part.replace(/,$/, ""))
    .filter(Boolean);
}

/** The station's value of a typed number; the text itself where it is none, which the station refuses by name. */
function numberOf(text: string, unit: string): number | string {
  const value = fromTyped(text, unit);
  return Number.isNaN(value) ? text.trim() : value;
}

/** A field's value in the document; undefined if nothing was entered. */
function entered(field: FormField, text: string): unknown {
  if (field.type === "switch") return text === "true" || undefined;
  if (text.trim() === "") return undefined;
  const unit = field.unit ?? "";
  if (field.type === "list") return listed(text).map((part) => numberOf(part, unit));
  if (field.type === "number") {
    const value = numberOf(text, unit);
    return typeof value === "number" && field.scale ? round(value * field.scale) : value;
  }
  if (field.key.endsWith(".sign")) return Number(text);
  return text.trim();
}

/** Sets a value at a place like "joints.2.limits_deg.0"; the parts on the way are made. */
function put(document: Plain, key: string, value: unknown): void {
  const names = key.split(".");
  const last = names.pop() ?? key;
  let part = document;
  names.forEach((name, i) => {
    const isList = /^\d+$/.test(names[i + 1] ?? last);
    part[name] ??= isList ? [] : {};
    part = part[name] as Plain;
  });
  if (value === undefined) delete part[last];
  else part[last] = value;
}

function look(document: Plain, key: string): unknown {
  return key.split(".").reduce<unknown>((part, name) => (part as Plain | null | undefined)?.[name], document);
}

function isEmpty(part: unknown): boolean {
  return typeof part === "object" && part !== null && Object.values(part).every((one) => one === undefined);
}

/** The document that the fields make; of an edited one, what no field holds stays. */
export function documentOf(name: FormName, values: Values, edited: Plain = {}): Plain {
  const { fixed, table } = FORMS[name];
  const document: Plain = { ...structuredClone(edited), ...fixed };
  if (table) {
    const before = partsOf(document, table.key);
    document[table.key] = Array.from({ length: rowCount(table, values) }, (_, row) => {
      const called = values[`${table.key}.${row}.name`];
      return called === undefined ? { ...before[row] } : { ...before[row], name: called };
    });
  }
  for (const field of fieldsOf(name, values)) put(document, field.key, entered(field, values[field.key] ?? ""));
  for (const key of ["tip", "inner_corners"]) if (isEmpty(document[key])) delete document[key];
  // what an identification found holds for the parameters that it found
  if (!isSame(document, edited, ["convention", "joints", "tip"])) delete document.identification;
  return document;
}

const isSame = (one: Plain, other: Plain, keys: string[]) =>
  keys.every((key) => JSON.stringify(one[key]) === JSON.stringify(other[key]));

/** What stands in the fields for a document. */
export function valuesOf(name: FormName, document: Plain): Values {
  const { table } = FORMS[name];
  const values: Values = {};
  if (table) {
    partsOf(document, table.key).forEach((part, row) => {
      Object.assign(values, table.first(row));
      if (part.name !== undefined) values[`${table.key}.${row}.name`] = String(part.name);
    });
  }
  for (const field of fieldsOf(name, values)) {
    const text = shown(field, look(document, field.key));
    if (text || field.type !== "choice") values[field.key] = text;
  }
  return values;
}

/** The fields of an arm whose joints and convention are those of a model; its name, where none was entered. */
export function withModel(values: Values, document: Plain): Values {
  const rest = Object.entries(values).filter(([key]) => !key.startsWith("joints."));
  const model = Object.entries(valuesOf("arm", document)).filter(([key]) => /^(joints\.|convention$)/.test(key));
  return Object.fromEntries([...rest, ...model, ["name", values.name || String(document.name ?? "")]]);
}

/** What belongs to one unit, and not to another that is like it. */
const OF_ONE_UNIT = ["serial_number", "certificate", "issued_on", "valid_until", "point_mm", "normal", "centre_mm"];

/** A document from which that of another thing begins; of an identified arm, without what was found of it. */
export function copyOf(document: Plain, name: string): Plain {
  const copy: Plain = { ...structuredClone(document), name };
  for (const key of OF_ONE_UNIT) delete copy[key];
  if (copy.identification) for (const joint of partsOf(copy, "joints")) delete joint.error;
  delete copy.identification;
  return copy;
}

/** The parts of a list of the document. */
function partsOf(document: Plain, key: string): Plain[] {
  return Array.isArray(document[key]) ? (document[key] as Plain[]) : [];
}

function shown(field: FormField, value: unknown): string {
  if (value === undefined || value === null) return "";
  const unit = field.unit ?? "";
  if (Array.isArray(value)) return value.map((one) => typed(Number(one), unit)).join("; ");
  if (typeof value !== "number") return String(value);
  return typed(value / (field.scale ?? 1), unit);
}

/** Edges from the widths of merlons and gaps one after the other; the first edge is at 0. */
export function edgesOf(widths: (number | string)[]): (number | string)[] {
  const edges: (number | string)[] = [0];
  let at = 0;
  for (const width of widths) {
    if (typeof width === "number") at = round(at + width);
    edges.push(typeof width === "number" ? at : width);
  }
  return edges;
}

/** Without what adding decimal fractions leaves behind the last figure. */
const round = (value: number) => Number(value.toPrecision(12));

/** Whether every needed field holds something. */
export function isFilled(name: FormName, values: Values): boolean {
  return fieldsOf(name, values).every(
    ({ key, optional, type }) => optional || type === "switch" || (values[key] ?? "").trim() !== "",
  );
}

/** The first field to which each of the station's problems belongs; "" of the whole document. */
export function placeOf(field: string, fields: readonly FormField[]): string {
  if (field === "") return "";
  const owner = fields.find(({ key }) => `${field}.`.startsWith(`${key}.`) || key.startsWith(`${field}.`));
  return owner?.key ?? "";
}
