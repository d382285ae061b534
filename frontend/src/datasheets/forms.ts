import type { DatasheetRow } from "../api/wire";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";

export type Kind = DatasheetRow["kind"];
export type FormName = NonNullable<DatasheetRow["form"]>;

export interface FormField {
  /** In the document, with points: "tip.x_mm", "inner_corners.0". */
  key: string;
  label: PlainId;
  /** A "list" has several lengths; a "date" is written as in ISO 8601. */
  type: "text" | "number" | "list" | "choice" | "switch" | "date";
  unit?: string;
  /** The document has the entered number times this: half of a diameter as radius. */
  scale?: number;
  choices?: readonly string[];
  optional?: boolean;
}

/** A table of a form: a row for each part of a list of the document. */
export interface Table {
  /** Of the list in the document. */
  key: string;
  label: PlainId;
  /** What stands above the rows' names. */
  rows: PlainId;
  columns: readonly FormField[];
  least: number;
  most: number;
  add: PlainId;
  remove: PlainId;
  /** What a new row holds, to be seen and changed. */
  first: (row: number) => Values;
}

export interface Form {
  kind: Kind;
  title: PlainId;
  /** What the document has beside the fields. */
  fixed: Record<string, unknown>;
  fields: readonly FormField[];
  table?: Table;
  /** What people call parts of the document with several fields. */
  parts?: Record<string, PlainId>;
  /** What the fields hold at first. */
  first: Values;
}

/** What stands in the fields. */
export type Values = Record<string, string>;

const NAME: FormField = { key: "name", label: "ui-name", type: "text" };
const SERIAL: FormField = { key: "serial_number", label: "ui-serial-number", type: "text" };
const SERIAL_IF_ANY: FormField = { ...SERIAL, optional: true };
const CERTIFICATE: FormField = { key: "certificate", label: "ui-certificate", type: "text", optional: true };
const ISSUED: FormField = { key: "issued_on", label: "ui-certificate-issued-on", type: "date", optional: true };
const UNTIL: FormField = { key: "valid_until", label: "ui-certificate-valid-until", type: "date", optional: true };
const mm = (key: string, label: PlainId): FormField => ({ key, label, type: "number", unit: "mm" });
const um = (key: string, label: PlainId): FormField => ({ key, label, type: "number", unit: "µm", optional: true });
const count = (key: string, label: PlainId, unit = ""): FormField => ({ key, label, type: "number", unit });
const SD = mm("standard_uncertainty_mm", "ui-standard-uncertainty");
const FLATNESS: FormField = { ...mm("flatness_mm", "ui-flatness-of-the-board"), optional: true };
const SQUARE = mm("square_mm", "ui-side-of-a-square");
const TIP = [
  mm("tip.x_mm", "ui-tip-x"),
  mm("tip.y_mm", "ui-tip-y"),
  mm("tip.z_mm", "ui-tip-z"),
  mm("tip.diameter_mm", "ui-tip-diameter"),
];
const PER_MILLION = { type: "number", unit: "µm/(m·K)", scale: 1e-6, optional: true } as const;
const EXPANSION: readonly FormField[] = [
  { key: "expansion_per_c", label: "ui-coefficient-of-expansion", ...PER_MILLION },
  { key: "expansion_sd_per_c", label: "ui-its-standard-uncertainty", ...PER_MILLION },
];
const GAUGE = [NAME, SERIAL_IF_ANY, CERTIFICATE, ISSUED, UNTIL];

const DICTIONARIES = [
  ...[4, 5, 6, 7].flatMap((bits) => [50, 100, 250, 1000].map((size) => `DICT_${bits}X${bits}_${size}`)),
  "DICT_ARUCO_ORIGINAL",
  "DICT_ARUCO_MIP_36h12",
  "DICT_APRILTAG_16h5",
  "DICT_APRILTAG_25h9",
  "DICT_APRILTAG_36h10",
  "DICT_APRILTAG_36h11",
];

const JOINTS: Table = {
  key: "joints",
  label: "ui-denavit-hartenberg-table",
  rows: "ui-joint-column",
  columns: [
    { key: "a_mm", label: "ui-joint-a", type: "number", unit: "mm" },
    { key: "alpha_deg", label: "ui-joint-alpha", type: "number", unit: "°" },
    { key: "d_mm", label: "ui-joint-d", type: "number", unit: "mm" },
    { key: "theta_deg", label: "ui-joint-theta", type: "number", unit: "°" },
    { key: "limits_deg.0", label: "ui-joint-lowest", type: "number", unit: "°" },
    { key: "limits_deg.1", label: "ui-joint-highest", type: "number", unit: "°" },
    { key: "sign", label: "ui-joint-sign", type: "choice", choices: ["1", "-1"] },
    { key: "encoder_sd_deg", label: "ui-joint-encoder", type: "number", unit: "°", optional: true },
  ],
  least: 5,
  most: 7,
  add: "ui-add-a-joint",
  remove: "ui-remove-the-last-joint",
  first: (row) => ({
    [`joints.${row}.name`]: `J${row + 1}`,
    [`joints.${row}.limits_deg.0`]: "-180",
    [`joints.${row}.limits_deg.1`]: "180",
    [`joints.${row}.sign`]: "1",
    [`joints.${row}.encoder_sd_deg`]: "0",
  }),
};
const LENGTHS: Table = {
  key: "lengths",
  label: "ui-calibrated-lengths",
  rows: "ui-number-column",
  columns: [
    { key: "length_mm", label: "ui-length", type: "number", unit: "mm" },
    { key: "standard_uncertainty_um", label: "ui-standard-uncertainty", type: "number", unit: "µm" },
  ],
  least: 1,
  most: 50,
  add: "ui-add-a-length",
  remove: "ui-remove-the-last-length",
  first: (row) => ({ [`lengths.${row}.length_mm`]: "" }),
};

/** The fields of a row of a table. */
export const rowFields = ({ key, columns }: Table, row: number): FormField[] =>
  columns.map((field) => ({ ...field, key: `${key}.${row}.${field.key}` }));

/** How many rows a table has. */
export function rowCount({ key }: Table, values: Values): number {
  const rows = Object.keys(values).filter((one) => one.startsWith(`${key}.`));
  return Math.max(-1, ...rows.map((one) => Number(one.split(".")[1]))) + 1;
}

/** What people call a row: a joint by its name, a length by its number. */
export const rowName = ({ key }: Table, row: number, values: Values): string =>
  values[`${key}.${row}.name`] ?? t("ui-number-n", { n: row + 1 });

/** What the first rows of a table hold. */
export const firstRows = ({ first }: Table, count: number): Values =>
  Object.assign({}, ...Array.from({ length: count }, (_, row) => first(row)));

export const FORMS: Record<FormName, Form> = {
  arm: {
    kind: "arm",
    title: "ui-arm-with-joints",
    fixed: { format: "crenel/arm", version: 1 },
    fields: [
      NAME,
      SERIAL_IF_ANY,
      { key: "convention", label: "ui-convention", type: "choice", choices: ["dh-standard", "dh-modified"] },
      ...TIP,
    ],
    table: JOINTS,
    parts: { tip: "ui-tip", joints: "ui-denavit-hartenberg-table", limits_deg: "ui-limits" },
    first: { convention: "dh-standard", ...firstRows(JOINTS, 6) },
  },
  robot: {
    kind: "arm",
    title: "ui-robot-that-reports-poses",
    fixed: { format: "crenel/arm", version: 1, convention: "pose" },
    fields: [NAME, SERIAL_IF_ANY, ...TIP.map((field) => ({ ...field, optional: true }))],
    first: {},
  },
  block: {
    kind: "object",
    title: "ui-crenellated-block",
    fixed: { format: "crenel/object", version: 1 },
    fields: [
      NAME,
      SERIAL,
      CERTIFICATE,
      ISSUED,
      { key: "edges_x_mm", label: "ui-edges-along-x", type: "list", unit: "mm" },
      mm("front_y_mm", "ui-front-y"),
      mm("back_y_mm", "ui-back-y"),
      mm("crest_z_mm", "ui-crest-z"),
      mm("floor_z_mm", "ui-floor-z"),
      mm("base_z_mm", "ui-base-z"),
      { ...SD, optional: true },
      { ...mm("tolerance_mm", "ui-tolerance-of-making"), optional: true },
    ],
    first: {},
  },
  chessboard: {
    kind: "object",
    title: "ui-chessboard",
    fixed: { format: "crenel/object", version: 1, kind: "chessboard" },
    fields: [
      NAME,
      SERIAL_IF_ANY,
      CERTIFICATE,
      ISSUED,
      count("inner_corners.0", "ui-columns-of-inner-corners"),
      count("inner_corners.1", "ui-rows-of-inner-corners"),
      SQUARE,
      SD,
      FLATNESS,
    ],
    first: { standard_uncertainty_mm: "0.05" },
  },
  charuco: {
    kind: "object",
    title: "ui-charuco-board",
    fixed: { format: "crenel/object", version: 1, kind: "charuco" },
    fields: [
      NAME,
      SERIAL_IF_ANY,
      CERTIFICATE,
      ISSUED,
      count("squares_x", "ui-squares-across"),
      count("squares_y", "ui-squares-down"),
      SQUARE,
      mm("marker_mm", "ui-side-of-a-marker"),
      { key: "dictionary", label: "ui-dictionary", type: "choice", choices: DICTIONARIES },
      { key: "legacy_pattern", label: "ui-arranged-as-before-opencv-4-6", type: "switch" },
      { ...count("first_id", "ui-id-of-the-first-marker"), optional: true },
      SD,
      FLATNESS,
    ],
    first: { dictionary: "DICT_4X4_50", standard_uncertainty_mm: "0.05" },
  },
  sensor: {
    kind: "sensor",
    title: "ui-sensor",
    fixed: { format: "crenel/sensor", version: 1 },
    fields: [
      NAME,
      SERIAL_IF_ANY,
      count("width_px", "ui-width-of-the-picture", "px"),
      count("height_px", "ui-height-of-the-picture", "px"),
      { key: "stripe_axis", label: "ui-how-does-the-laser-line-run", type: "choice", choices: ["u", "v"] },
      { key: "laser_wavelength_nm", label: "ui-wavelength-of-the-laser", type: "number", unit: "nm", optional: true },
      { ...count("focal_px", "ui-focal-length", "px"), optional: true },
      { ...mm("standoff_mm", "ui-stand-off"), optional: true },
    ],
    first: { stripe_axis: "u" },
  },
  sphere: {
    kind: "gauge",
    title: "ui-sphere",
    fixed: { format: "crenel/nominal", version: 1, shape: "sphere" },
    fields: [
      ...GAUGE,
      { ...mm("radius_mm", "ui-diameter"), scale: 0.5 },
      um("standard_uncertainty_um", "ui-standard-uncertainty-of-the-radius"),
      um("form_um", "ui-form-deviation"),
      ...EXPANSION,
    ],
    first: {},
  },
  plane: {
    kind: "gauge",
    title: "ui-plate",
    fixed: { format: "crenel/nominal", version: 1, shape: "plane" },
    fields: [
      ...GAUGE,
      { ...mm("width_mm", "ui-narrower-side"), optional: true },
      um("form_um", "ui-form-deviation"),
      um("standard_uncertainty_um", "ui-its-standard-uncertainty"),
      ...EXPANSION,
    ],
    first: {},
  },
  "ball-bar": {
    kind: "gauge",
    title: "ui-ball-bar",
    fixed: { format: "crenel/length-standard", version: 1, kind: "ball-bar" },
    fields: [
      ...GAUGE,
      { ...mm("sphere_diameter_mm", "ui-diameter-of-the-spheres"), optional: true },
      um("sphere_form_um", "ui-form-deviation-of-the-spheres"),
      ...EXPANSION,
    ],
    table: LENGTHS,
    first: firstRows(LENGTHS, 1),
  },
  "step-gauge": {
    kind: "gauge",
    title: "ui-step-gauge",
    fixed: { format: "crenel/length-standard", version: 1, kind: "step-gauge" },
    fields: [...GAUGE, ...EXPANSION],
    table: LENGTHS,
    first: firstRows(LENGTHS, 5),
  },
};

/** The forms of a kind of datasheet. */
export const formsOf = (kind: Kind) => (Object.keys(FORMS) as FormName[]).filter((name) => FORMS[name].kind === kind);

export const isForm = (name: string | null): name is FormName => name !== null && name in FORMS;

/** All fields of a form, with the rows of the table as they are now. */
export function fieldsOf(name: FormName, values: Values): FormField[] {
  const { fields, table } = FORMS[name];
  const rows = table ? Array.from({ length: rowCount(table, values) }, (_, row) => rowFields(table, row)) : [];
  return [...fields, ...rows.flat()];
}
