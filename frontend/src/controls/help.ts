import type { PlainId } from "../messages/text";

/** Help for each step beyond its one sentence: a few lines, displayed on request. */
export const HELP: Readonly<Record<string, readonly PlainId[]>> = {
  "flow/devices": ["ui-arm-sensor-detected-automatically-missing-device", "ui-you-reload-page-switch-another-tablet"],
  "flow/setup": ["ui-select-datasheets-clamped-mounted-result-only", "ui-wrong-tip-object-appears-residuals-later"],
  "flow/touch": [
    "ui-clamp-object-cannot-move-until-last",
    "ui-arms-main-button-takes-point-undo",
    "ui-spread-points-over-face-away-edges",
    "ui-keep-elbow-and-wrist-as-they-are",
  ],
  "flow/place": [
    "ui-hold-sensor-object-fills-picture-laser",
    "ui-keep-elbow-and-wrist-as-they-are",
    "ui-arms-main-button-continues-long-press",
  ],
  "flow/capture": ["ui-picture-taken-only-while-arm-still", "ui-arms-main-button-takes-long-press"],
  "flow/solve": ["ui-poses-another-tilt-rotation-improve-result", "ui-arms-main-button-triggers-large-button"],
  "flow/review": [
    "ui-k-1-about-two-three-points",
    "ui-check-where-largest-residuals-pose-excluded",
    "ui-nothing-takes-effect-before-you-accept",
  ],
  "verify/gauge": ["ui-use-gauge-certificate-size-form-uncertainty", "ui-clamp-must-not-move-between-first"],
  "verify/touch": ["ui-arms-main-button-takes-contact-point", "ui-without-contact-points-only-form-size"],
  "verify/scan": ["ui-arms-main-button-starts-ends-cloud", "ui-move-slowly-evenly-green-range-distance"],
  "verify/review": ["ui-pass-value-within-by-guard-band"],
  "performance/artefact": ["ui-performance-help-sphere", "ui-performance-help-limits"],
  "performance/pattern": ["ui-performance-help-touch", "ui-performance-help-places"],
  "performance/location": ["ui-performance-help-location"],
  "performance/scan": ["ui-performance-help-scan", "ui-performance-help-patches"],
  "performance/end": ["ui-performance-help-end"],
  "performance/lengths": ["ui-performance-help-touch", "ui-performance-help-length"],
  "performance/temperatures": ["ui-performance-help-temperatures"],
  "performance/review": ["ui-performance-help-review"],
  "parts/align": ["ui-part-help-touch", "ui-part-help-frame"],
  "parts/measure": ["ui-part-help-touch", "ui-part-help-next", "ui-part-help-u"],
  "parts/review": ["ui-part-help-review"],
  "arm/seat": ["ui-seat-cone-three-balls-which-tip", "ui-the-arms-main-button-begins"],
  "arm/swing": ["ui-leave-tip-seat-turn-every-joint", "ui-the-arms-main-button-ends-it"],
  "arm/touch": ["ui-hold-still-place-arms-main-button"],
  scan: ["ui-stay-green-range-distance-indicator-if", "ui-pass-over-place-again-fill-gaps"],
};
