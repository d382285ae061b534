import type { FaceProgress } from "../api/types";
import { CheckIcon } from "../parts/icons";
import { figures } from "../parts/format";
import styles from "./FaceChips.module.css";

interface FaceChipsProps {
  faces: FaceProgress[];
  onSelect: (face: string) => void;
}

/** The faces to touch, each with its count; the way to choose one by glove or by key. */
export function FaceChips({ faces, onSelect }: FaceChipsProps) {
  return (
    <div className={styles.chips} role="group" aria-label="Faces">
      {faces.map((face) => (
        <button
          key={face.face}
          type="button"
          className={styles.chip}
          aria-pressed={face.selected}
          onClick={() => onSelect(face.face)}
        >
          <span className={styles.title}>
            {face.title}
            {face.taken >= face.wanted && <CheckIcon size="1rem" />}
          </span>
          <span className={styles.count}>
            {face.taken} of {face.wanted}
            {face.rms_um !== null && <span className={styles.rms}>{figures(face.rms_um)} µm rms</span>}
          </span>
        </button>
      ))}
    </div>
  );
}
