import type { DatasheetRow } from "../api/wire";
import type { PlainId } from "../messages/text";

export type Kind = DatasheetRow["kind"];
/** What can be entered; of other datasheets, the file is uploaded. */
export type FormName = "arm" | "robot" | "block" | "chessboard" | "charuco" | "sphere" | "plane";

export interface FormField {
  /** In the document, with points: "tip.x_mm", "inner_corners.0". */
  key: string;
  label: PlainId;
  /** A "list" has several lengths; of "half" the document has half, as a radius of a diameter. */
  type: "text" | "number" | "half" | "list" | "choice" | "switch";
  unit?: string;
  choices?: readonly string[];
  optional?: boolean;
}

export interface Form {
  kind: Kind;
  title: PlainId;
  /** What the document has beside the fields. */
  fixed: Record<string, unknown>;
  fields: readonly FormField[];
  /** What the fields hold at first. */
  first: Values;
}

/** What stands in the fields. */
export type Values = Record<string, string>;

const NAME: FormField = { key: "name", label: "ui-name", type: "text" };
const SERIAL: FormField = { key: "serial_number", label: "ui-serial-number", type: "text" };
const SERIAL_IF_ANY: FormField = { ...SERIAL, optional: true };
const CERTIFICATE: FormField = { key: "certificate", label: "ui-certificate", type: "text", optional: true };
const UNTIL: FormField = { key: "valid_until", label: "ui-certificate-valid-until", type: "text", optional: true };
const mm = (key: string, label: PlainId): FormField => ({ key, label, type: "number", unit: "mm" });
const um = (key: string, label: PlainId): FormField => ({ key, label, type: "number", unit: "µm", optional: true });
const count = (key: string, label: PlainId): FormField => ({ key, label, type: "number" });
const SD = mm("standard_uncertainty_mm", "ui-standard-uncertainty");
const FLATNESS: FormField = { ...mm("flatness_mm", "ui-flatness-of-the-board"), optional: true };
const SQUARE = mm("square_mm", "ui-side-of-a-square");
const TIP = [
  mm("tip.x_mm", "ui-tip-x"),
  mm("tip.y_mm", "ui-tip-y"),
  mm("tip.z_mm", "ui-tip-z"),
  mm("tip.diameter_mm", "ui-tip-diameter"),
];
const GAUGE = [um("standard_uncertainty_um", "ui-standard-uncertainty"), um("form_um", "ui-form-deviation")];

const DICTIONARIES = [
  ...[4, 5, 6, 7].flatMap((bits) => [50, 100, 250, 1000].map((size) => `DICT_${bits}X${bits}_${size}`)),
  "DICT_ARUCO_ORIGINAL",
  "DICT_ARUCO_MIP_36h12",
  "DICT_APRILTAG_16h5",
  "DICT_APRILTAG_25h9",
  "DICT_APRILTAG_36h10",
  "DICT_APRILTAG_36h11",
];

/** Joints of the table, in which `KEY` stands for the number of the row. */
export const JOINT: readonly FormField[] = [
  { key: "a_mm", label: "ui-joint-a", type: "number", unit: "mm" },
  { key: "alpha_deg", label: "ui-joint-alpha", type: "number", unit: "°" },
  { key: "d_mm", label: "ui-joint-d", type: "number", unit: "mm" },
  { key: "theta_deg", label: "ui-joint-theta", type: "number", unit: "°" },
  { key: "limits_deg.0", label: "ui-joint-lowest", type: "number", unit: "°" },
  { key: "limits_deg.1", label: "ui-joint-highest", type: "number", unit: "°" },
  { key: "sign", label: "ui-joint-sign", type: "choice", choices: ["1", "-1"] },
  { key: "encoder_sd_deg", label: "ui-joint-encoder", type: "number", unit: "°" },
];
export const LEAST_JOINTS = 5;
export const MOST_JOINTS = 7;

/** The fields of a row of the table. */
export const jointFields = (row: number): FormField[] =>
  JOINT.map((field) => ({ ...field, key: `joints.${row}.${field.key}` }));

/** What a new row holds: the limits and the sign that most joints have, to be seen and changed. */
export const firstJoint = (row: number): Values => ({
  [`joints.${row}.name`]: `J${row + 1}`,
  [`joints.${row}.limits_deg.0`]: "-180",
  [`joints.${row}.limits_deg.1`]: "180",
  [`joints.${row}.sign`]: "1",
  [`joints.${row}.encoder_sd_deg`]: "0",
});

/** How many rows the table has. */
export function jointCount(values: Values): number {
  const rows = Object.keys(values).map((key) => Number(/^joints\.(\d+)\.name$/.exec(key)?.[1] ?? -1));
  return Math.max(-1, ...rows) + 1;
}

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
    first: {
      convention: "dh-standard",
      ...Object.assign({}, ...[0, 1, 2, 3, 4, 5].map(firstJoint)),
    },
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
      { key: "edges_x_mm", label: "ui-edges-along-x", type: "list", unit: "mm" },
      mm("front_y_mm", "ui-front-y"),
      mm("back_y_mm", "ui-back-y"),
      mm("crest_z_mm", "ui-crest-z"),
      mm("floor_z_mm", "ui-floor-z"),
      mm("base_z_mm", "ui-base-z"),
      SD,
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
      count("squares_x", "ui-squares-across"),
      count("squares_y", "ui-squares-down"),
      SQUARE,
      mm("marker_mm", "ui-side-of-a-marker"),
      { key: "dictionary", label: "ui-dictionary", type: "choice", choices: DICTIONARIES },
      { key: "legacy_pattern", label: "ui-arranged-as-before-opencv-4-6", type: "switch" },
      SD,
      FLATNESS,
    ],
    first: { dictionary: "DICT_4X4_50", standard_uncertainty_mm: "0.05" },
  },
  sphere: {
    kind: "gauge",
    title: "ui-sphere",
    fixed: { format: "crenel/nominal", version: 1, shape: "sphere" },
    fields: [
      NAME,
      SERIAL_IF_ANY,
      CERTIFICATE,
      UNTIL,
      { key: "radius_mm", label: "ui-diameter", type: "half", unit: "mm" },
      um("standard_uncertainty_um", "ui-standard-uncertainty-of-the-radius"),
      um("form_um", "ui-form-deviation"),
    ],
    first: {},
  },
  plane: {
    kind: "gauge",
    title: "ui-plate",
    fixed: { format: "crenel/nominal", version: 1, shape: "plane" },
    fields: [
      NAME,
      SERIAL_IF_ANY,
      CERTIFICATE,
      UNTIL,
      { ...mm("width_mm", "ui-narrower-side"), optional: true },
      ...GAUGE,
    ],
    first: {},
  },
};

/** The forms of a kind of datasheet; those of sensors come from the connected camera. */
export const formsOf = (kind: Kind) => (Object.keys(FORMS) as FormName[]).filter((name) => FORMS[name].kind === kind);

export const isForm = (name: string | null): name is FormName => name !== null && name in FORMS;

/** All fields of a form, with the rows of the table as they are now. */
export function fieldsOf(name: FormName, values: Values): FormField[] {
  const table = name === "arm" ? Array.from({ length: jointCount(values) }, (_, row) => jointFields(row)).flat() : [];
  return [...FORMS[name].fields, ...table];
}
