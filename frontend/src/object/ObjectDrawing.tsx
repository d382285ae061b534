import { useElementSize } from "@mantine/hooks";
import { type ReactNode, useMemo } from "react";

import type { ObjectGeometry } from "../api/types";
import { BlockDrawing } from "./BlockDrawing";
import { BoardDrawing } from "./BoardDrawing";
import styles from "./ObjectDrawing.module.css";
import { footprint } from "./shape";
import { useHeading } from "./useHeading";
import { headingFor, makeView, pathOf, type View } from "./view";

interface ObjectDrawingProps {
  object: ObjectGeometry;
  /** The face that is turned to the viewer and highlighted. */
  face: string | null;
  onFace?: (face: string) => void;
  label: string;
  /** Drawn on top. */
  children?: (view: View) => ReactNode;
}

/** The block or the board from its certificate, in parallel projection. */
export function ObjectDrawing({ object, face, onFace, label, children }: ObjectDrawingProps) {
  const { ref, width, height } = useElementSize<HTMLDivElement>();
  const heading = useHeading(headingFor(object, face));
  const view = useMemo(() => makeView(object, heading, width, height), [object, heading, width, height]);
  return (
    <div ref={ref} className={styles.drawing}>
      {width > 0 && height > 0 && (
        <svg width={width} height={height} role="group" aria-label={label}>
          <path d={pathOf(view, footprint(object))} className={styles.shadow} />
          {object.kind === "block" ? (
            <BlockDrawing block={object} view={view} face={face} onFace={onFace} />
          ) : (
            <BoardDrawing board={object} view={view} face={face} onFace={onFace} />
          )}
          {children?.(view)}
        </svg>
      )}
    </div>
  );
}
