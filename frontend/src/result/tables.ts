import type { ObjectGeometry } from "../api/types";
import type { CalibrationResult, PoseRow, WorstPointLine } from "../api/wire";
import type { Cell, TableData } from "../controls/table";
import { message, type PlainId, quantity } from "../messages/text";
import { wordText } from "../state/language";
import { partOf } from "./names";

export const POSES: PlainId = "ui-poses";
const KINDS = {
  corner: "ui-corner",
  contact: "ui-contact",
  stripe: "ui-stripe-lowercase",
} as const satisfies Record<WorstPointLine["kind"], PlainId>;
const DISTORTION = ["k1", "k2", "p1", "p2", "k3"];

/** All figures of a result, as displayed or as sent. */
export function tablesOf(result: CalibrationResult, object: ObjectGeometry): TableData[] {
  return [
    ...facesTables(result),
    {
      title: POSES,
      head: [
        "ui-pose",
        { title: partOf(object), unit: "px" },
        { title: "ui-stripe", unit: "px" },
        { title: "ui-deviation", unit: "µm" },
      ],
      rows: result.poses.map(poseCells),
    },
    {
      title: "ui-largest-residuals",
      head: ["ui-where", "ui-type", "ui-residual", "ui-unit"],
      rows: result.worst.map(({ kind, name, value, unit }) => [
        name,
        message(KINDS[kind]),
        quantity(value, unit, unit === "px" ? 3 : 1),
        { unit },
      ]),
    },
    {
      title: "ui-error-budget-k-1",
      head: ["ui-source", { symbol: "", unit: "µm" }],
      rows: [
        ...result.budget.map((row) => [row.source, quantity(row.value_um, "µm", 2)]),
        [message("ui-together"), quantity(result.total_um, "µm", 2)],
      ],
    },
    {
      title: "ui-probe-matrix-t-flange-sensor",
      wide: true,
      head: ["ui-row", { symbol: "x" }, { symbol: "y" }, { symbol: "z" }, { symbol: "t", unit: "mm" }],
      rows: result.probe_matrix.map((row, i) => [
        String(i + 1),
        ...row.map((value, j) => (j === 3 && i < 3 ? quantity(value, "mm", 3) : quantity(value, "", 6))),
      ]),
    },
    {
      title: "ui-lens-distortion",
      head: ["ui-term", "ui-value"],
      rows: result.distortion.map((value, i) => [DISTORTION[i] ?? `d${i}`, quantity(value, "", 6)]),
    },
  ];
}

function poseCells(pose: PoseRow): Cell[] {
  const number = String(pose.number);
  if (!pose.used) return [number, message("ui-left-out-reason", { reason: pose.reason }), "", ""];
  const stripe = pose.stripe_rms_px === null ? message("ui-left-out") : quantity(pose.stripe_rms_px, "px", 3);
  return [number, quantity(pose.edges_rms_px, "px", 3), stripe, quantity(pose.off_um, "µm")];
}

/** None if the object was not touched. */
function facesTables({ faces }: CalibrationResult): TableData[] {
  if (faces.length === 0) return [];
  return [
    {
      title: "ui-faces",
      head: ["ui-face", "ui-points", { title: "ui-rms", unit: "µm" }, { title: "ui-form", unit: "µm" }],
      rows: faces.map((f) => [
        wordText(f.face),
        quantity(f.points),
        quantity(f.rms_um, "µm", 1),
        quantity(f.form_um, "µm", 1),
      ]),
    },
  ];
}
