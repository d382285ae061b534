import type { CalibrationResult } from "../api/types";
import { amount, type TableData } from "../parts/table";
import { cornerWords } from "./names";

export const POSES = "Poses";
const DISTORTION = ["k1", "k2", "p1", "p2", "k3"];

export function tablesOf(result: CalibrationResult): TableData[] {
  return [
    {
      title: "Faces",
      head: ["Face", "Points", { words: "rms", unit: "µm" }, { words: "Form", unit: "µm" }],
      rows: result.faces.map((f) => [f.face, amount(f.points, 0), amount(f.rms_um, 1, "µm"), amount(f.form_um, 1, "µm")]),
    },
    {
      title: POSES,
      head: ["Pose", { words: "Edges", unit: "px" }, { words: "Stripe", unit: "px" }, { words: "Off", unit: "µm" }],
      rows: result.poses.map((p) =>
        p.used
          ? [String(p.number), amount(p.edges_rms_px, 3), amount(p.stripe_rms_px, 3), amount(p.off_um, 0, "µm")]
          : [String(p.number), `left out: ${p.reason}`, "", ""],
      ),
    },
    {
      title: "Largest residuals",
      head: ["Where", "Kind", "Residual", "Unit"],
      rows: result.worst.map((w) => [
        w.kind === "corner" ? cornerWords(w.name) : w.name,
        w.kind,
        amount(w.value, w.unit === "px" ? 3 : 1, w.unit),
        { unit: w.unit },
      ]),
    },
    {
      title: "Error budget, k = 1",
      head: ["Source", { words: "", unit: "µm" }],
      rows: [
        ...result.budget.map((row) => [row.source, amount(row.value_um, 2, "µm")]),
        ["Together", amount(result.total_um, 2, "µm")],
      ],
    },
    {
      title: "Probe matrix T_flange_sensor",
      wide: true,
      head: ["Row", "x", "y", "z", { words: "t", unit: "mm" }],
      rows: result.probe_matrix.map((row, i) => [
        String(i + 1),
        ...row.map((value, j) => amount(value, j === 3 && i < 3 ? 3 : 6, j === 3 && i < 3 ? "mm" : "")),
      ]),
    },
    {
      title: "Lens distortion",
      head: ["Term", "Value"],
      rows: result.distortion.map((value, i) => [DISTORTION[i] ?? `d${i}`, amount(value, 6)]),
    },
  ];
}
