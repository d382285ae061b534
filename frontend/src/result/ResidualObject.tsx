import { useState } from "react";

import type { ObjectGeometry } from "../api/types";
import type { TouchedPoint, WorstPointLine } from "../api/wire";
import styles from "../flow/ObjectPicture.module.css";
import { PointPanel } from "../flow/PointPanel";
import { ResidualLegend } from "../flow/ResidualLegend";
import { ObjectDrawing } from "../object/ObjectDrawing";
import { scaleEnd } from "../object/residuals";
import { ResidualSticks, Touches } from "../object/Touches";
import { t } from "../state/language";

interface ResidualObjectProps {
  object: ObjectGeometry;
  points: TouchedPoint[];
  worst: WorstPointLine[];
}

/** The distance of each contact point from its face; the object turns to the face that is tapped. */
export function ResidualObject({ object, points, worst }: ResidualObjectProps) {
  const [face, setFace] = useState<string | null>(null);
  const [chosen, setChosen] = useState<number | null>(null);
  const scale_um = scaleEnd(points);
  const point = points.find((p) => p.index === chosen);
  return (
    <div className={styles.picture}>
      <ObjectDrawing
        object={object}
        face={face}
        onFace={(tapped) => setFace(tapped === face ? null : tapped)}
        label={t("ui-residuals-on-the-object")}
      >
        {(view) => (
          <>
            <ResidualSticks view={view} object={object} points={points} scale_um={scale_um} />
            <Touches
              view={view}
              object={object}
              points={points}
              scale_um={scale_um}
              chosen={chosen}
              onPoint={setChosen}
              named={worst.flatMap((w) => (w.point === null ? [] : [w.point]))}
            />
          </>
        )}
      </ObjectDrawing>
      {point && <PointPanel point={point} onClose={() => setChosen(null)} removable={false} />}
      <div className={styles.legend}>
        {points.length > 0 ? <ResidualLegend scale_um={scale_um} sticks /> : <p>{t("ui-the-board-was-not-touched")}</p>}
      </div>
    </div>
  );
}
