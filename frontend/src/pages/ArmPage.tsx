import { useState } from "react";

import { NextStep } from "../home/NextStep";
import { startArm } from "../api/armCommands";
import { ArmCard } from "../arm/ArmCard";
import { ArmPictureView } from "../arm/ArmPictureView";
import { History, type Past } from "../arm/History";
import { Layout } from "../frame/Layout";
import { MainAct } from "../parts/Actions";
import { t } from "../state/language";
import { Chips } from "../parts/Chips";
import { CardHead } from "../parts/CardHead";
import { PressButton } from "../parts/PressButton";
import { getState, useLive } from "../state/store";
import styles from "./ArmPage.module.css";

const PAST = { check: "arm", tip: "tip", identify: "identified" } as const;

/** The arm itself: its daily check with the history, and its identification. */
export function ArmPage() {
  const view = useLive((s) => s.arm);
  if (!view?.running) return <NotStarted />;
  return <Layout picture={<ArmPictureView view={view} />} card={<ArmCard view={view} />} />;
}

function NotStarted() {
  // what was done last is looked at first
  const [past, setPast] = useState<Past>(() => PAST[getState().arm?.purpose ?? "check"]);
  return (
    <Layout
      picture={
        <>
          <div className={styles.chips}>
            <Chips
              label={t("What was checked")}
              options={[
                { value: "arm", label: t("Arm") },
                { value: "tip", label: t("Tip") },
                { value: "identified", label: t("Identifications") },
              ]}
              value={past}
              onChange={setPast}
            />
          </div>
          <History of={past} />
        </>
      }
      card={
        <>
          <CardHead
            title={t("Is the arm in order?")}
            text={t("Hold the tip in a cone or ball seat and swing the arm about it: what the tip seems to move by is the arm's own error. It takes five minutes.")}
          />
          <MainAct>
            <PressButton kind="primary" onPress={() => startArm("check")}>
              {t("Check the arm")}
            </PressButton>
          </MainAct>
          <div className={styles.other}>
            <h2 className={styles.heading}>{t("Check the tip")}</h2>
            <p className={styles.text}>
              {t("Before work: touch a sphere of known diameter nine times. A worn, bent or wrong tip shows at once. It takes a minute.")}
            </p>
            <PressButton onPress={() => startArm("tip")}>{t("Check the tip")}</PressButton>
          </div>
          <div className={styles.other}>
            <h2 className={styles.heading}>{t("Identify the arm")}</h2>
            <p className={styles.text}>
              {t("From six seats, spheres or places of a ball bar all over the reach the arm's geometry is determined anew. Do it when a check fails, or before the first calibration.")}
            </p>
            <PressButton onPress={() => startArm("identify")}>{t("Identify the arm")}</PressButton>
          </div>
          <NextStep />
        </>
      }
    />
  );
}
