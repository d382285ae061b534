import { useRef, useState } from "react";

import { newKey } from "../../api/commands";
import { CloudView } from "../../scan/CloudView";
import { DistanceSign } from "../../scan/DistanceSign";
import { LegendBar } from "../../scan/LegendBar";
import { t } from "../../state/language";
import { useLive } from "../../state/store";
import { GaugeDrawing } from "../plan/GaugeDrawing";
import styles from "./LiveScan.module.css";

interface LiveScanProps {
  shape: "plane" | "sphere" | null;
  state: "before" | "scanning" | "measuring" | "done";
}

/** The growing cloud on the gauge, with instructions; before the scan, only the instructions. */
export function LiveScan({ shape, state }: LiveScanProps) {
  const frame = useRef<HTMLIFrameElement>(null);
  const [viewKey] = useState(newKey);
  const legend = useLive((s) => s.view?.legend ?? null);
  const scanning = state === "scanning";
  const visible = scanning || state === "measuring";
  return (
    <>
      <div className={styles.live} data-visible={visible || undefined}>
        <CloudView viewKey={viewKey} frame={frame}>
          {scanning && <DistanceSign />}
          {visible && legend && <LegendBar legend={legend} />}
        </CloudView>
      </div>
      {(scanning || state === "before") && (
        <div className={styles.guide} data-beside={scanning || undefined}>
          <GaugeDrawing shape={shape} scanning />
          <p className={styles.words}>
            {scanning ? t("ui-keep-stripe-gauge-move-slowly-points") : t("ui-pass-becomes-map-clouds-deviations-gauge")}
          </p>
        </div>
      )}
    </>
  );
}
