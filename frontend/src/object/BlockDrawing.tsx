import { useMemo } from "react";

import type { BlockGeometry } from "../api/wire";
import styles from "./BlockDrawing.module.css";
import { type Patch, visiblePatches } from "./block";
import { pathOf, type View } from "./view";

interface BlockDrawingProps {
  block: BlockGeometry;
  view: View;
  /** Highlighted. */
  face: string | null;
  onFace: ((face: string) => void) | undefined;
}

/** The block's surface, with hidden parts hidden. */
export function BlockDrawing({ block, view, face, onFace }: BlockDrawingProps) {
  const patches = useMemo(() => visiblePatches(block, view.to), [block, view.to]);
  return patches.map((patch) => (
    <PatchPath
      key={patch.id}
      patch={patch}
      view={view}
      chosen={patch.face !== null && patch.face === face}
      onFace={onFace}
    />
  ));
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
