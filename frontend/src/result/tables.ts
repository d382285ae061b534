import type { CalibrationResult } from "../api/types";
import type { TableData } from "../parts/DataTable";
import { figures } from "../parts/format";
import { cornerWords } from "./names";

export const POSES = "Poses";
const DISTORTION = ["k1", "k2", "p1", "p2", "k3"];

export function tablesOf(result: CalibrationResult): TableData[] {
  return [
    {
      title: "Faces",
      head: ["Face", "Points", "rms, µm", "Form, µm"],
      rows: result.faces.map((f) => [f.face, figures(f.points), figures(f.rms_um, 1), figures(f.form_um, 1)]),
    },
    {
      title: POSES,
      head: ["Pose", "Edges, px", "Stripe, px", "Off, µm"],
      rows: result.poses.map((p) =>
        p.used
          ? [String(p.number), figures(p.edges_rms_px, 3), figures(p.stripe_rms_px, 3), figures(p.off_um)]
          : [String(p.number), `left out: ${p.reason}`, "", ""],
      ),
    },
    {
      title: "Largest residuals",
      head: ["Where", "Kind", "Residual", "Unit"],
      rows: result.worst.map((w) => [
        w.kind === "corner" ? cornerWords(w.name) : w.name,
        w.kind,
        figures(w.value, w.unit === "px" ? 3 : 1),
        w.unit,
      ]),
    },
    {
      title: "Error budget, k = 1",
      head: ["Source", "µm"],
      rows: [
        ...result.budget.map((row) => [row.source, figures(row.value_um, 2)]),
        ["Together", figures(result.total_um, 2)],
      ],
    },
    {
      title: "Probe matrix T_flange_sensor",
      wide: true,
      head: ["Row", "x", "y", "z", "t, mm"],
      rows: result.probe_matrix.map((row, i) => [
        String(i + 1),
        ...row.map((value, j) => figures(value, j === 3 && i < 3 ? 3 : 6)),
      ]),
    },
    {
      title: "Lens distortion",
      head: ["Term", "Value"],
      rows: result.distortion.map((value, i) => [DISTORTION[i] ?? `d${i}`, figures(value, 6)]),
    },
  ];
}
