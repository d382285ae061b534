import type { ReactNode } from "react";

import { MainAct } from "../../controls/Actions";
import { CardHead } from "../../controls/CardHead";
import { PressButton } from "../../controls/PressButton";
import { t } from "../../state/language";
import { go } from "../../state/router";

interface Props {
  title: string;
  /** What is needed. */
  text: string;
  /** Whether a calibration is in use, or none is needed. */
  calibrated: boolean;
  start: string;
  onStart: () => Promise<void>;
  /** What is chosen or prepared before. */
  children?: ReactNode;
}

/** Begins a session that may need a calibration in use; without one, leads there. */
export function StartCard({ title, text, calibrated, start, onStart, children }: Props) {
  return (
    <>
      <CardHead title={title} text={calibrated ? text : t("ui-no-calibration-use-yet-calibrate-first")} />
      {children}
      <MainAct>
        {calibrated ? (
          <PressButton kind="primary" onPress={onStart}>
            {start}
          </PressButton>
        ) : (
          <PressButton free kind="primary" onPress={() => go("calibrate")}>
            {t("ui-calibrate")}
          </PressButton>
        )}
      </MainAct>
    </>
  );
}
