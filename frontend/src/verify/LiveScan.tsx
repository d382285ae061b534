import { useRef, useState } from "react";

import { newKey } from "../api/commands";
import { CloudView } from "../scan/CloudView";
import { DistanceSign } from "../scan/DistanceSign";
import { LegendBar } from "../scan/LegendBar";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { GaugeDrawing } from "./GaugeDrawing";
import styles from "./LiveScan.module.css";

interface LiveScanProps {
  shape: "plane" | "sphere" | null;
  state: "before" | "scanning" | "measuring" | "done";
}

/** The cloud as it grows on the gauge, with how to pass over it; before that, only the latter. */
export function LiveScan({ shape, state }: LiveScanProps) {
  const frame = useRef<HTMLIFrameElement>(null);
  const [viewKey] = useState(newKey);
  const legend = useLive((s) => s.view?.legend ?? null);
  const scanning = state === "scanning";
  const shown = scanning || state === "measuring";
  return (
    <>
      <div className={styles.live} data-shown={shown || undefined}>
        <CloudView viewKey={viewKey} frame={frame}>
          {scanning && <DistanceSign />}
          {shown && legend && <LegendBar legend={legend} />}
        </CloudView>
      </div>
      {(scanning || state === "before") && (
        <div className={styles.guide} data-beside={scanning || undefined}>
          <GaugeDrawing shape={shape} scanning />
          <p className={styles.words}>
            {scanning ? t("Keep the stripe on the gauge. Slowly: the points come as you pass.") : t("Each pass becomes a map of where the cloud lies off the gauge.")}
          </p>
        </div>
      )}
    </>
  );
}
