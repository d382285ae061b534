import { useEffect } from "react";

import { sendCommand } from "../api/guideCommands";
import type { TouchedPoint } from "../api/wire";
import { CloseIcon } from "../controls/icons";
import { signedLength, unitOf } from "../controls/lengths";
import { PressButton } from "../controls/PressButton";
import { BOARD_FACE } from "../object/board";
import { t, word } from "../state/language";
import styles from "./PointPanel.module.css";

const NOT_YET = {
  block: "ui-distance-known-once-three-adjacent-faces",
  board: "ui-distance-known-once-board-touched-more",
} as const;

interface PointPanelProps {
  point: TouchedPoint;
  onClose: () => void;
  removable: boolean;
}

/** One touched point: how far off it lies, and the way to take it back. */
export function PointPanel({ point, onClose, removable }: PointPanelProps) {
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => event.key === "Escape" && onClose();
    window.addEventListener("keydown", onKey);
    return () => window.removeEventListener("keydown", onKey);
  }, [onClose]);

  const remove = async () => {
    await sendCommand("flow", "void_point", { index: point.index });
    onClose();
  };
  return (
    <div className={styles.panel} role="dialog" aria-label={t("ui-point", { n: point.index + 1 })}>
      <div className={styles.head}>
        <span>
          {t("ui-point", { n: point.index + 1 })}, {word(point.face)}
        </span>
        <button type="button" className={styles.close} aria-label={t("ui-close")} onClick={onClose}>
          <CloseIcon size="1.25rem" />
        </button>
      </div>
      <div className={styles.value}>
        {point.residual_um === null ? `– ${unitOf("µm")}` : signedLength(point.residual_um, "µm")}
      </div>
      <p className={styles.text}>
        {point.outlier
          ? t("ui-outlier-does-not-fit-face-not")
          : point.residual_um === null
            ? t(point.face === BOARD_FACE ? NOT_YET.board : NOT_YET.block)
            : t("ui-distance-from-its-face-outward")}
      </p>
      {removable && <PressButton onPress={remove}>{t("ui-remove-this-point")}</PressButton>}
    </div>
  );
}
