import { type ReactNode, useRef, useState } from "react";

import { newKey } from "../api/commands";
import type { Region, ShapeName } from "../api/types";
import { fitShape } from "../api/viewCommands";
import { LiveCamera } from "../image/LiveCamera";
import type { PlainId } from "../messages/text";
import look from "../parts/Control.module.css";
import { CameraIcon, CloudsIcon, ColoursIcon, MeasureIcon, ScanIcon } from "../parts/icons";
import { notify } from "../state/banner";
import { useBarred } from "../state/control";
import { t } from "../state/language";
import { getState, useLive } from "../state/store";
import { CloudView } from "./CloudView";
import { ColourPanel } from "./ColourPanel";
import { DistanceSign } from "./DistanceSign";
import { LegendBar } from "./LegendBar";
import { MeasurePanel } from "./MeasurePanel";
import { PickOverlay } from "./PickOverlay";
import styles from "./ScanPicture.module.css";
import { ScansPanel } from "./ScansPanel";
import { savePicture } from "./savePicture";
import { ViewpointButtons } from "./ViewpointButtons";

type Panel = "camera" | "scans" | "colours" | "measure";

const TITLES: Record<Panel, PlainId> = {
  camera: "ui-camera",
  scans: "ui-scans",
  colours: "ui-colours",
  measure: "ui-measure",
};
const TOOLS: { panel: Panel; icon: ReactNode }[] = [
  { panel: "camera", icon: <ScanIcon /> },
  { panel: "scans", icon: <CloudsIcon /> },
  { panel: "colours", icon: <ColoursIcon /> },
  { panel: "measure", icon: <MeasureIcon /> },
];

/** The 3D view with what can be done in it; one panel is open at a time. */
export function ScanPicture() {
  const frame = useRef<HTMLIFrameElement>(null);
  const [viewKey] = useState(newKey);
  const [panel, setPanel] = useState<Panel | null>(null);
  const [picking, setPicking] = useState<ShapeName | null>(null);
  const barred = useBarred();
  const legend = useLive((s) => s.view?.legend ?? null);
  const toggle = (one: Panel) => {
    setPicking(null);
    setPanel(panel === one ? null : one);
  };
  const pick = (region: Region) => {
    if (picking) void fitShape(viewKey, picking, region);
    setPicking(null);
  };
  return (
    <CloudView viewKey={viewKey} frame={frame}>
      {picking && <PickOverlay shape={picking} onPick={pick} onCancel={() => setPicking(null)} />}
      <div className={styles.tools} role="toolbar" aria-label={t("ui-3d-view")} hidden={picking !== null}>
        {TOOLS.map((tool) => (
          <button
            key={tool.panel}
            type="button"
            className={`${look.button} ${styles.tool}`}
            aria-expanded={panel === tool.panel}
            onClick={() => toggle(tool.panel)}
          >
            {tool.icon}
            {t(TITLES[tool.panel])}
          </button>
        ))}
        <button type="button" className={`${look.button} ${styles.tool}`} onClick={() => void save(frame.current)}>
          <CameraIcon />
          {t("ui-save-picture")}
        </button>
      </div>
      {panel && !picking && (
        <section className={styles.panel} aria-label={t(TITLES[panel])}>
          {barred && <p className={styles.barred}>{barred}</p>}
          {panel === "camera" && (
            <div className={styles.camera}>
              <LiveCamera bare />
            </div>
          )}
          {panel === "scans" && <ScansPanel />}
          {panel === "colours" && <ColourPanel />}
          {panel === "measure" && <MeasurePanel onPick={setPicking} />}
        </section>
      )}
      {!picking && <ViewpointButtons viewKey={viewKey} />}
      <DistanceSign />
      {legend && <LegendBar legend={legend} />}
    </CloudView>
  );
}

async function save(frame: HTMLIFrameElement | null): Promise<void> {
  const { view, station } = getState();
  const saved = frame !== null && (await savePicture(frame, view?.legend ?? null, station?.name ?? ""));
  if (!saved) notify({ quality: "attention", title: t("ui-picture-not-saved-3d-view-not") }, 6000);
}
