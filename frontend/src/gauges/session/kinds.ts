import type { PerformanceView } from "../../api/wire";
import type { PlainId } from "../../messages/text";

export type Kind = PerformanceView["test"];

/** What is said of a kind of performance test before it begins. */
interface KindTexts {
  label: PlainId;
  title: PlainId;
  /** What it is, where no test was done yet. */
  about: PlainId;
  needs: PlainId;
  /** Whether it cannot be done by touch alone: the sensor must be calibrated. */
  scans: boolean;
}

export const KINDS: Record<Kind, KindTexts> = {
  sphere: {
    label: "ui-one-sphere",
    title: "ui-test-the-performance",
    about: "ui-performance-first-text",
    needs: "ui-performance-needs",
    scans: true,
  },
  lengths: {
    label: "ui-lengths",
    title: "ui-length-test",
    about: "ui-lengths-first-text",
    needs: "ui-lengths-need",
    scans: false,
  },
  plane: {
    label: "ui-plane-test",
    title: "ui-plane-test-title",
    about: "ui-plane-about",
    needs: "ui-plane-needs",
    scans: true,
  },
  contact: {
    label: "ui-contact-test",
    title: "ui-contact-test-title",
    about: "ui-contact-about",
    needs: "ui-contact-needs",
    scans: false,
  },
};
