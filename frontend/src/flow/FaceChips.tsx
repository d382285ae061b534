import type { FaceProgress } from "../api/wire";
import { CheckIcon } from "../controls/icons";
import { measured } from "../controls/lengths";
import { t } from "../state/language";
import styles from "./FaceChips.module.css";

interface FaceChipsProps {
  faces: FaceProgress[];
  onSelect: (face: string) => void;
}

function count({ taken, wanted }: FaceProgress): string {
  if (wanted > 0) return t("ui-done-of-all", { done: taken, all: wanted });
  return taken > 0 ? t("ui-n-points", { n: taken }) : t("ui-not-needed");
}

/** The faces to touch, each with its count; selectable with gloves or keys. */
export function FaceChips({ faces, onSelect }: FaceChipsProps) {
  return (
    <div className={styles.chips} role="group" aria-label={t("ui-faces")}>
      {faces.map((face) => (
        <button
          key={face.face}
          type="button"
          className={styles.chip}
          aria-pressed={face.selected}
          onClick={() => onSelect(face.face)}
        >
          <span className={styles.title}>
            <span>{face.title}</span>
            {face.wanted > 0 && face.taken >= face.wanted && <CheckIcon size="1rem" />}
          </span>
          <span className={styles.count}>
            {count(face)}
            {face.rms_um !== null && <span className={styles.rms}>{measured(face.rms_um, "µm")} rms</span>}
          </span>
        </button>
      ))}
    </div>
  );
}
