import { useEffect } from "react";

import { sendFlow } from "../api/commands";
import type { TouchedPoint } from "../api/flowTypes";
import { BOARD_FACE } from "../object/board";
import { CloseIcon } from "../parts/icons";
import { signedLength, unitOf } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { said, t, words } from "../state/language";
import styles from "./PointPanel.module.css";

const NOT_YET = {
  block: words("Its distance is known once three faces that meet have been touched."),
  board: words("Its distance is known once the board has been touched in more places."),
};

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
    await sendFlow("void_point", { index: point.index });
    onClose();
  };
  return (
    <div className={styles.panel} role="dialog" aria-label={t("Point {n}", { n: point.index + 1 })}>
      <div className={styles.head}>
        <span>
          {t("Point {n}", { n: point.index + 1 })}, {said(point.face)}
        </span>
        <button type="button" className={styles.close} aria-label={t("Close")} onClick={onClose}>
          <CloseIcon size="1.25rem" />
        </button>
      </div>
      <div className={styles.value}>{point.residual_um === null ? `– ${unitOf("µm")}` : signedLength(point.residual_um, "µm")}</div>
      <p className={styles.text}>
        {point.outlier
          ? t("Outlier: it does not fit its face and is not used.")
          : point.residual_um === null
            ? t(point.face === BOARD_FACE ? NOT_YET.board : NOT_YET.block)
            : t("Distance from its face, + outward.")}
      </p>
      {removable && <PressButton onPress={remove}>{t("Remove this point")}</PressButton>}
    </div>
  );
}
