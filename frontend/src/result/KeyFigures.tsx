import type { ObjectGeometry } from "../api/types";
import type { CalibrationResult } from "../api/wire";
import { figures } from "../controls/format";
import { lengthFigures, unitOf } from "../controls/lengths";
import { Readouts } from "../controls/Readouts";
import { t } from "../state/language";

/** The key figures for a metrologist. */
export function KeyFigures({ result, object }: { result: CalibrationResult; object: ObjectGeometry }) {
  const [near, far] = result.depth_range_mm;
  return (
    <Readouts
      wrap
      readouts={[
        {
          label: object.kind === "board" ? t("ui-corners-rms") : t("ui-edges-rms"),
          value: figures(result.reprojection_rms_px, 3),
          unit: "px",
        },
        result.laser_plane_rms_um === null
          ? { label: t("ui-laser-plane-rms"), value: t("ui-none-yet"), unit: "" }
          : {
              label: t("ui-laser-plane-rms"),
              value: lengthFigures(result.laser_plane_rms_um, "µm"),
              unit: unitOf("µm"),
            },
        ...(result.alignment_rms_um === null
          ? []
          : [
              {
                label: t("ui-contact-points-rms"),
                value: lengthFigures(result.alignment_rms_um, "µm"),
                unit: unitOf("µm"),
              },
            ]),
        {
          label: t("ui-depth-range"),
          value: t("ui-range", { low: lengthFigures(near, "mm", 1), high: lengthFigures(far, "mm", 1) }),
          unit: unitOf("mm"),
        },
        ...(result.plane
          ? [
              { label: t("ui-planes-angle-k-1"), value: figures(result.plane.angle_arcsec), unit: "″" },
              {
                label: t("ui-planes-offset-k-1"),
                value: lengthFigures(result.plane.offset_um, "µm", 1),
                unit: unitOf("µm"),
              },
            ]
          : []),
      ]}
    />
  );
}
