import type { ComponentType } from "react";

import type { PerformanceFile, PerformanceView } from "../../api/wire";
import type { PlainId } from "../../messages/text";

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
  /** Drawn where no test was done yet. */
  Drawing?: ComponentType;
  /** What can be prepared before the test. */
  Before?: ComponentType;
  /** The title of the choice of its gauge. */
  gauge: PlainId;
  /** Said of the choice to do the test without its gauge; missing: it needs one. */
  without?: PlainId;
  /** Shown where there is no gauge. */
  NoGauge?: ComponentType;
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
