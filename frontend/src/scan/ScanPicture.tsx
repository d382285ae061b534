import { type ReactNode, type RefObject, useCallback, useLayoutEffect, useRef, useState } from "react";

import { newKey } from "../api/commands";
import { askPlace } from "../api/partCommands";
import type { AskedShape, Region } from "../api/types";
import { cutPoints, fitShape } from "../api/viewCommands";
import type { PlaceOnMap } from "../api/wire";
import look from "../controls/Control.module.css";
import { CameraIcon, CloudsIcon, ColoursIcon, CompareIcon, CutIcon, MeasureIcon, ScanIcon } from "../controls/icons";
import { LiveCamera } from "../image/LiveCamera";
import type { PlainId } from "../messages/text";
import { ComparePanel } from "../parts/ComparePanel";
import { drawMapLegend } from "../parts/drawMapLegend";
import { MapLegend } from "../parts/MapLegend";
import { shownMapOf, useShownMap } from "../parts/shownMap";
import { useMapTap } from "../parts/useMapTap";
import { notify } from "../state/banner";
import { useBarred } from "../state/control";
import { t } from "../state/language";
import { getState, useLive } from "../state/store";
import { CloudView } from "./CloudView";
import { CutPanel } from "./CutPanel";
import { DisplayPanel } from "./DisplayPanel";
import { DistanceSign } from "./DistanceSign";
import { LegendBar } from "./LegendBar";
import { MeasurePanel } from "./MeasurePanel";
import { PickOverlay } from "./PickOverlay";
import styles from "./ScanPicture.module.css";
import { ScansPanel } from "./ScansPanel";
import { drawLegend, savePicture } from "./savePicture";
import { ViewpointButtons } from "./ViewpointButtons";
import { controlsOf, keepWidth } from "./viewCamera";

type Panel = "camera" | "scans" | "display" | "measure" | "compare" | "cut";
/** What a rectangle is drawn for. */
type Purpose = { shape: AskedShape } | { outside: boolean };

const TITLES: Record<Panel, PlainId> = {
  camera: "ui-camera",
  scans: "ui-scans",
  display: "ui-display",
  measure: "ui-measure",
  compare: "ui-compare",
  cut: "ui-cut",
};
const TOOLS: { panel: Panel; icon: ReactNode }[] = [
  { panel: "camera", icon: <ScanIcon /> },
  { panel: "scans", icon: <CloudsIcon /> },
  { panel: "display", icon: <ColoursIcon /> },
  { panel: "measure", icon: <MeasureIcon /> },
  { panel: "compare", icon: <CompareIcon /> },
  { panel: "cut", icon: <CutIcon /> },
];
const DRAW: Record<AskedShape, PlainId> = {
  any: "ui-draw-a-rectangle-over-the-shape",
  cone: "ui-draw-a-rectangle-over-the-cone",
  plane: "ui-draw-a-rectangle-over-the-plane",
  sphere: "ui-draw-a-rectangle-over-the-sphere",
  cylinder: "ui-draw-a-rectangle-over-the-cylinder",
};

function wordsOf(purpose: Purpose): PlainId {
  if ("shape" in purpose) return DRAW[purpose.shape];
  return purpose.outside ? "ui-draw-a-rectangle-around-what-stays" : "ui-draw-a-rectangle-around-what-goes";
}

/** The 3D view with what can be done in it; one panel is open at a time. */
export function ScanPicture() {
  const frame = useRef<HTMLIFrameElement>(null);
  const [viewKey] = useState(newKey);
  const [panel, setPanel] = useState<Panel | null>(null);
  const [picking, setPicking] = useState<Purpose | null>(null);
  const barred = useBarred();
  const legend = useLive((s) => s.view?.legend ?? null);
  const map = useShownMap();
  const [place, setPlace] = useState<PlaceOnMap | null>(null);
  const closePlace = useCallback(() => setPlace(null), []);
  const compared = map?.result.scan ?? null;
  const tap = useCallback(
    async (x: number, y: number) => {
      if (!compared) return;
      const found = await askPlace(compared, { view: viewKey, x, y });
      setPlace(found);
      if (found && found.state !== "nothing") setPanel("compare");
    },
    [compared, viewKey],
  );
  useMapTap(frame, compared !== null && picking === null, tap);
  const toggle = (one: Panel) => {
    setPicking(null);
    setPanel(panel === one ? null : one);
  };
  const pick = (region: Region) => {
    if (picking && "shape" in picking) void fitShape(viewKey, picking.shape, region);
    else if (picking) void cutPoints(viewKey, region, picking.outside);
    setPicking(null);
  };
  useKeptWidth(frame, panel !== null && picking === null);
  return (
    <CloudView viewKey={viewKey} frame={frame}>
      {picking && <PickOverlay words={t(wordsOf(picking))} onPick={pick} onCancel={() => setPicking(null)} />}
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
        <section className={styles.panel} aria-label={t(TITLES[panel])} data-panel>
          {barred && <p className={styles.barred}>{barred}</p>}
          {panel === "camera" && (
            <div className={styles.camera}>
              <LiveCamera bare />
            </div>
          )}
          {panel === "scans" && <ScansPanel />}
          {panel === "display" && <DisplayPanel />}
          {panel === "measure" && <MeasurePanel onPick={(shape) => setPicking({ shape })} />}
          {panel === "compare" && <ComparePanel place={place} onClosePlace={closePlace} />}
          {panel === "cut" && <CutPanel onDraw={(outside) => setPicking({ outside })} />}
        </section>
      )}
      <div className={styles.free}>
        {!picking && <ViewpointButtons viewKey={viewKey} />}
        <DistanceSign />
        {map ? <MapLegend shown={map} /> : legend && <LegendBar legend={legend} />}
      </div>
    </CloudView>
  );
}

/** What is seen stays in view when a panel beside the picture opens or closes. */
function useKeptWidth(frame: RefObject<HTMLIFrameElement | null>, beside: boolean): void {
  const before = useRef({ beside, width: 0 });
  useLayoutEffect(() => {
    const width = frame.current?.clientWidth ?? 0;
    const controls = controlsOf(frame.current?.contentWindow ?? null);
    if (controls && before.current.beside !== beside && width && before.current.width)
      keepWidth(controls, width / before.current.width);
    before.current = { beside, width };
  });
}

async function save(frame: HTMLIFrameElement | null): Promise<void> {
  const { view, station } = getState();
  const map = shownMapOf(getState());
  const legend = map ? drawMapLegend(map) : view?.legend ? drawLegend(view.legend) : null;
  const saved = frame !== null && (await savePicture(frame, legend, station?.name ?? ""));
  if (!saved) notify({ quality: "attention", title: t("ui-picture-not-saved-3d-view-not") }, 6000);
}
