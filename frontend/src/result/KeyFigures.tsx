import type { CalibrationResult } from "../api/types";
import { figures } from "../parts/format";
import { Readouts } from "../parts/Readouts";

/** The figures that a metrologist looks for first. */
export function KeyFigures({ result }: { result: CalibrationResult }) {
  const [near, far] = result.depth_range_mm;
  return (
    <Readouts
      wrap
      readouts={[
        { label: "Edges, rms", value: figures(result.reprojection_rms_px, 3), unit: "px" },
        { label: "Laser plane, rms", value: figures(result.laser_plane_rms_um), unit: "µm" },
        { label: "Touches, rms", value: figures(result.alignment_rms_um), unit: "µm" },
        { label: "Depth range", value: `${figures(near, 1)} to ${figures(far, 1)}`, unit: "mm" },
        ...(result.plane
          ? [
              { label: "Plane's angle, k = 1", value: figures(result.plane.angle_arcsec), unit: "″" },
              { label: "Plane's offset, k = 1", value: figures(result.plane.offset_um, 1), unit: "µm" },
            ]
          : []),
      ]}
    />
  );
}
