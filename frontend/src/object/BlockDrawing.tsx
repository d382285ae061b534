import { useElementSize } from "@mantine/hooks";
import { type ReactNode, useMemo } from "react";

import type { BlockGeometry } from "../api/flowTypes";
import styles from "./BlockDrawing.module.css";
import { footprint, type Patch, visiblePatches } from "./block";
import { useHeading } from "./useHeading";
import { headingFor, makeView, pathOf, type View } from "./view";

interface BlockDrawingProps {
  block: BlockGeometry;
  /** Seen best, and highlighted. */
  face: string | null;
  onFace?: (face: string) => void;
  label: string;
  children?: (view: View) => ReactNode;
}

/** The block as its certificate has it, in parallel projection with hidden parts hidden. */
export function BlockDrawing({ block, face, onFace, label, children }: BlockDrawingProps) {
  const { ref, width, height } = useElementSize<HTMLDivElement>();
  const heading = useHeading(headingFor(face));
  const view = useMemo(() => makeView(block, heading, width, height), [block, heading, width, height]);
  const patches = useMemo(() => visiblePatches(block, view.to), [block, view.to]);
  return (
    <div ref={ref} className={styles.drawing}>
      {width > 0 && height > 0 && (
        <svg width={width} height={height} role="group" aria-label={label}>
          <path d={pathOf(view, footprint(block))} className={styles.shadow} />
          {patches.map((patch) => (
            <PatchPath key={patch.id} patch={patch} view={view} chosen={patch.face !== null && patch.face === face} onFace={onFace} />
          ))}
          {children?.(view)}
        </svg>
      )}
    </div>
  );
}

interface PatchPathProps {
  patch: Patch;
  view: View;
  chosen: boolean;
  onFace: ((face: string) => void) | undefined;
}

function shade(patch: Patch): string {
  if (patch.normal[2] !== 0) return "top";
  return patch.normal[1] !== 0 ? "front" : "side";
}

function PatchPath({ patch, view, chosen, onFace }: PatchPathProps) {
  const face = patch.face;
  return (
    <path
      d={pathOf(view, patch.outline)}
      className={styles.patch}
      data-shade={shade(patch)}
      data-chosen={chosen || undefined}
      data-face={face ?? undefined}
      data-pressable={face && onFace ? true : undefined}
      onClick={face && onFace ? () => onFace(face) : undefined}
    />
  );
}
