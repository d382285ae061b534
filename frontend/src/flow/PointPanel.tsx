import { useEffect } from "react";

import { sendFlow } from "../api/commands";
import type { TouchedPoint } from "../api/types";
import { CloseIcon } from "../parts/icons";
import { signedLength, unitOf } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import styles from "./PointPanel.module.css";

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
    <div className={styles.panel} role="dialog" aria-label={`Point ${point.index + 1}`}>
      <div className={styles.head}>
        <span>
          Point {point.index + 1}, {point.face}
        </span>
        <button type="button" className={styles.close} aria-label="Close" onClick={onClose}>
          <CloseIcon size="1.25rem" />
        </button>
      </div>
      <div className={styles.value}>{point.residual_um === null ? `– ${unitOf("µm")}` : signedLength(point.residual_um, "µm")}</div>
      <p className={styles.text}>
        {point.outlier ? "Outlier: it does not fit its face and is not used." : "Distance from its face, + outward."}
      </p>
      {removable && <PressButton onPress={remove}>Remove this point</PressButton>}
    </div>
  );
}
