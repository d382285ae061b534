import { useState } from "react";
import { startArm } from "../api/guideCommands";
import { ArmCard } from "../arm/ArmCard";
import { ArmPictureView } from "../arm/ArmPictureView";
import { History, type Past } from "../arm/History";
import { MainAct } from "../controls/Actions";
import { CardHead } from "../controls/CardHead";
import { Chips } from "../controls/Chips";
import { PressButton } from "../controls/PressButton";
import { Layout } from "../frame/Layout";
import { NextStep } from "../home/NextStep";
import { t } from "../state/language";
import { getState, useLive } from "../state/store";
import { useAbsent } from "../state/useAbsent";
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
  const absent = useAbsent("arm");
  const off = absent !== "";
  const [past, setPast] = useState<Past>(() => PAST[getState().arm?.purpose ?? "check"]);
  return (
    <Layout
      picture={
        <>
          <div className={styles.chips}>
            <Chips
              label={t("ui-checks")}
              options={[
                { value: "arm", label: t("ui-arm") },
                { value: "tip", label: t("ui-tip") },
                { value: "identified", label: t("ui-identifications") },
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
          <CardHead title={t("ui-is-the-arm-in-order")} text={t("ui-hold-tip-cone-ball-seat-swing")} />
          <MainAct>
            <PressButton kind="primary" disabled={off} why={absent} onPress={() => startArm("check")}>
              {t("ui-check-the-arm")}
            </PressButton>
          </MainAct>
          <div className={styles.other}>
            <h2 className={styles.heading}>{t("ui-check-the-tip")}</h2>
            <p className={styles.text}>{t("ui-before-measuring-touch-sphere-known-diameter")}</p>
            <PressButton disabled={off} onPress={() => startArm("tip")}>
              {t("ui-check-the-tip")}
            </PressButton>
          </div>
          <div className={styles.other}>
            <h2 className={styles.heading}>{t("ui-identify-the-arm")}</h2>
            <p className={styles.text}>{t("ui-six-seats-spheres-ball-bar-places")}</p>
            <PressButton disabled={off} onPress={() => startArm("identify")}>
              {t("ui-identify-the-arm")}
            </PressButton>
          </div>
          <NextStep />
        </>
      }
    />
  );
}
