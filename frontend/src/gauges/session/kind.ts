import type { ComponentProps, ComponentType } from "react";

import type { PerformanceFile, PerformanceView } from "../../api/wire";
import type { PlainId } from "../../messages/text";
import type { GaugeDrawing } from "../plan/GaugeDrawing";

interface OfView {
  view: PerformanceView;
}

/** What the pages show of a kind of performance test. */
export interface Kind {
  label: PlainId;
  title: PlainId;
  /** What it is, where no test was done yet. */
  about: PlainId;
  needs: PlainId;
  /** Whether it cannot be done by touch alone: the sensor must be calibrated. */
  scans: boolean;
  /** Its gauge, drawn where no test was done yet, and where there is none. */
  drawing?: ComponentProps<typeof GaugeDrawing>;
  /** What can be prepared before the test. */
  Before?: ComponentType;
  /** The title of the choice of its gauge. */
  gauge: PlainId;
  /** Said of the choice to do the test without its gauge; missing: it needs one. */
  without?: PlainId;
  /** Said where there is no gauge: a title, and what to do. */
  noGauge?: [PlainId, PlainId];
  /** What is chosen beside the gauge. */
  Choices?: ComponentType<OfView>;
  /** Whether the gauge has a size, which depends on its temperature. */
  sized: boolean;
  /** Drawn in the steps of its own. */
  Picture: ComponentType<OfView>;
  /** Drawn below the figures of a result. */
  Result?: ComponentType<OfView>;
  /** The same of a test that is over. */
  Record?: ComponentType<{ file: PerformanceFile }>;
}

/** The choice to do a test without a gauge. */
export function withoutOption(label: string, detail: string) {
  return { id: "", label, detail, why_not: "" };
}
