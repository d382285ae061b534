import { useState } from "react";
import { setValue } from "../api/guideCommands";
import type { ObjectGeometry, Picture, Vec3 } from "../api/types";
import type { FaceProgress, TouchedPoint } from "../api/wire";
import { Chips } from "../controls/Chips";
import type { PlainId } from "../messages/text";
import { ObjectDrawing } from "../object/ObjectDrawing";
import { scaleEnd } from "../object/residuals";
import { Suggestions, Touches } from "../object/Touches";
import { t } from "../state/language";
import { FaceChips } from "./FaceChips";
import { LastEvent } from "./LastEvent";
import styles from "./ObjectPicture.module.css";
import { PointPanel } from "./PointPanel";
import { ResidualLegend } from "./ResidualLegend";

type ObjectView = Extract<Picture, { kind: "object" }>;

/** The suggested places without those that a point lies nearest to. */
function stillToTouch(face: FaceProgress, points: TouchedPoint[]): Vec3[] {
  const left = [...face.suggested_mm];
  for (const { at_mm, face: touched, outlier } of points) {
    if (!at_mm || outlier || touched !== face.face || left.length === 0) continue;
    const far = left.map((place) => Math.hypot(...place.map((x, i) => x - (at_mm[i] ?? 0))));
    left.splice(far.indexOf(Math.min(...far)), 1);
  }
  return left;
}

/** Where to touch, and how well each touch fits. */
export function ObjectPicture({ picture }: { picture: ObjectView }) {
  const { object, faces, points } = picture;
  const [chosen, setChosen] = useState<number | null>(null);
  const selected = faces.find((face) => face.selected) ?? null;
  const scale_um = scaleEnd(points);
  const point = points.find((p) => p.index === chosen) ?? null;
  const select = (face: string) => void setValue("flow", "select_face", { face });
  return (
    <div className={styles.picture}>
      <ObjectDrawing object={object} face={selected?.face ?? null} onFace={select} label={t("ui-the-object")}>
        {(view) => (
          <>
            {selected && <Suggestions view={view} face={selected.face} places={stillToTouch(selected, points)} />}
            <Touches
              view={view}
              object={object}
              points={points}
              scale_um={scale_um}
              chosen={chosen}
              onPoint={(index) => setChosen(index === chosen ? null : index)}
            />
          </>
        )}
      </ObjectDrawing>
      {point && <PointPanel key={point.index} point={point} onClose={() => setChosen(null)} removable />}
      <LastEvent>
        <Note kind={object.kind} points={points} scale_um={scale_um} />
      </LastEvent>
      <Unplaced points={points.filter(({ face }) => face === selected?.face)} chosen={chosen} onPoint={setChosen} />
      {faces.length > 1 && <FaceChips faces={faces} onSelect={select} />}
    </div>
  );
}

interface UnplacedProps {
  points: TouchedPoint[];
  chosen: number | null;
  onPoint: (index: number) => void;
}

/** Points whose place on the object is not known yet: each can be taken out all the same. */
function Unplaced({ points, chosen, onPoint }: UnplacedProps) {
  const options = points
    .filter(({ at_mm }) => !at_mm)
    .map(({ index, outlier }) => ({
      value: index,
      label: `${index + 1}`,
      mark: outlier ? t("ui-outlier") : undefined,
    }));
  return (
    <div className={styles.points}>
      <Chips label={t("ui-points-on-this-face")} options={options} value={chosen ?? -1} onChange={onPoint} />
    </div>
  );
}

const NOTES: Record<ObjectGeometry["kind"], { untouched: PlainId; unplaced: PlainId }> = {
  block: {
    untouched: "ui-touch-rings-point-appears-residual",
    unplaced: "ui-points-appear-drawing-once-three-adjacent",
  },
  board: {
    untouched: "ui-touch-rings-continue-chessboard-need-not",
    unplaced: "ui-points-appear-drawing-once-pictures-evaluated",
  },
};

interface NoteProps {
  kind: ObjectGeometry["kind"];
  points: TouchedPoint[];
  scale_um: number;
}

function Note({ kind, points, scale_um }: NoteProps) {
  const placed = points.some((point) => point.at_mm);
  if (placed) return <ResidualLegend scale_um={scale_um} />;
  const { untouched, unplaced } = NOTES[kind];
  return <p>{t(points.length === 0 ? untouched : unplaced)}</p>;
}
