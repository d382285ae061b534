import type { ObjectGeometry } from "../api/flowTypes";
import type { CalibrationResult, WorstPoint } from "../api/resultTypes";
import { amount, type TableData } from "../parts/table";
import { said, t, words } from "../state/language";
import { filled } from "../state/sentences";
import { cornerWords, partOf } from "./names";

export const POSES = words("Poses");
const KINDS: Record<WorstPoint["kind"], string> = { corner: words("corner"), contact: words("contact"), stripe: words("stripe") };
const DISTORTION = ["k1", "k2", "p1", "p2", "k3"];

export function tablesOf(result: CalibrationResult, object: ObjectGeometry): TableData[] {
  return [
    ...facesTables(result),
    {
      title: POSES,
      head: [words("Pose"), { words: partOf(object), unit: "px" }, { words: words("Stripe"), unit: "px" }, { words: words("Off"), unit: "µm" }],
      rows: result.poses.map((p) =>
        p.used
          ? [String(p.number), amount(p.edges_rms_px, 3), p.stripe_rms_px === null ? { plain: "left out", shown: t("left out") } : amount(p.stripe_rms_px, 3), amount(p.off_um, 0, "µm")]
          : [String(p.number), { plain: `left out: ${p.reason}`, shown: t("left out: {reason}", { reason: p.reason }) }, "", ""],
      ),
    },
    {
      title: words("Largest residuals"),
      head: [words("Where"), words("Kind"), words("Residual"), words("Unit")],
      rows: result.worst.map((w) => [
        w.kind === "corner" ? { plain: cornerWords(w.name, filled), shown: cornerWords(w.name) } : { plain: w.name, shown: said(w.name) },
        { plain: w.kind, shown: t(KINDS[w.kind]) },
        amount(w.value, w.unit === "px" ? 3 : 1, w.unit),
        { unit: w.unit },
      ]),
    },
    {
      title: words("Error budget, k = 1"),
      head: [words("Source"), { words: "", unit: "µm" }],
      rows: [
        ...result.budget.map((row) => [row.source, amount(row.value_um, 2, "µm")]),
        [words("Together"), amount(result.total_um, 2, "µm")],
      ],
    },
    {
      title: words("Probe matrix T_flange_sensor"),
      wide: true,
      head: [words("Row"), "x", "y", "z", { words: "t", unit: "mm" }],
      rows: result.probe_matrix.map((row, i) => [
        String(i + 1),
        ...row.map((value, j) => amount(value, j === 3 && i < 3 ? 3 : 6, j === 3 && i < 3 ? "mm" : "")),
      ]),
    },
    {
      title: words("Lens distortion"),
      head: [words("Term"), words("Value")],
      rows: result.distortion.map((value, i) => [DISTORTION[i] ?? `d${i}`, amount(value, 6)]),
    },
  ];
}

/** None where the object was not touched. */
function facesTables({ faces }: CalibrationResult): TableData[] {
  if (faces.length === 0) return [];
  return [
    {
      title: words("Faces"),
      head: [words("Face"), words("Points"), { words: words("rms"), unit: "µm" }, { words: words("Form"), unit: "µm" }],
      rows: faces.map((f) => [f.face, amount(f.points, 0), amount(f.rms_um, 1, "µm"), amount(f.form_um, 1, "µm")]),
    },
  ];
}
