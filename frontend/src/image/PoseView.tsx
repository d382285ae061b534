import { sendCommand } from "../api/guideCommands";
import type { PosePicture, WorstPointLine } from "../api/wire";
import { Download } from "../controls/Download";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import { type PlainId, quantity } from "../messages/text";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./PoseView.module.css";
import { StillImage } from "./StillImage";

interface PoseViewProps {
  poses: PosePicture[];
  /** Number of the pose whose picture is displayed. */
  selected: number;
  onShow: (number: number) => void;
  /** Draws each corner's residual, enlarged. */
  residuals?: boolean;
  worst?: WorstPointLine[];
  /** What was measured in the pictures, once poses are solved: corners or edges. */
  part?: PlainId;
}

const STATES: Record<PosePicture["state"], PlainId | null> = {
  taken: null,
  used: null,
  left_out: "ui-left-out",
  aside: "ui-excluded",
};

/** The poses side by side, the picture of one of them, and the button to exclude it. */
export function PoseView({ poses, selected, onShow, residuals = false, worst = [], part = "ui-edges" }: PoseViewProps) {
  const pose = poses.find(({ number }) => number === selected) ?? poses[poses.length - 1];
  const role = useLive((s) => s.session?.you?.role);
  if (!pose) return null;
  const bundle_url = role === "viewer" ? "" : pose.bundle_url;
  return (
    <div className={styles.view}>
      {(poses.length > 1 || bundle_url) && (
        <div className={styles.strip}>
          {poses.length > 1 && (
            <div className={styles.poses} role="group" aria-label={t("ui-poses")}>
              {poses.map(({ number, state, note }) => (
                <button
                  key={number}
                  type="button"
                  className={styles.pose}
                  aria-pressed={number === pose.number}
                  aria-label={[t("ui-pose-n", { n: number }), STATES[state] && t(STATES[state])]
                    .filter(Boolean)
                    .join(", ")}
                  data-state={state}
                  onClick={() => onShow(number)}
                >
                  {number}
                  {note !== "" && state !== "aside" && <QualityMark quality="attention" size="1rem" />}
                </button>
              ))}
            </div>
          )}
          <p className={styles.summary}>{summary(pose, part)}</p>
          {bundle_url && <Download href={bundle_url}>{t("ui-save-picture-for-support")}</Download>}
          {poses.length > 1 && pose.action && <ExcludeButton pose={pose} />}
        </div>
      )}
      <StillImage {...pose} residuals={residuals} worst={worst.filter((w) => w.pose === pose.number)} />
    </div>
  );
}

/** Excludes or includes a pose; why not, where that is not possible. */
export function ExcludeButton({ pose }: { pose: PosePicture }) {
  const { action } = pose;
  if (!action) return null;
  return (
    <PressButton
      key={action.name}
      disabled={!action.enabled}
      why={action.why_not}
      onPress={() => sendCommand("flow", action.name, action.args)}
    >
      {action.label}
    </PressButton>
  );
}

function summary({ number, note, edges_rms_px, off_um }: PosePicture, part: PlainId): string {
  if (note) return note;
  if (edges_rms_px === null || off_um === null) return t("ui-pose-n", { n: number });
  return t("ui-rms-off-the-others", {
    part: t(part),
    px: quantity(edges_rms_px, "px", 3),
    off: quantity(off_um, "µm"),
  });
}
