import { sendFlow } from "../api/commands";
import type { PosePicture, WorstPoint } from "../api/resultTypes";
import { bound, figures } from "../parts/format";
import { measured } from "../parts/lengths";
import { PressButton } from "../parts/PressButton";
import { QualityMark } from "../parts/QualityMark";
import { t, words } from "../state/language";
import styles from "./PoseView.module.css";
import { StillImage } from "./StillImage";

interface PoseViewProps {
  poses: PosePicture[];
  /** Number of the pose whose picture is shown. */
  shown: number;
  onShow: (number: number) => void;
  /** Draws each corner's residual, enlarged. */
  residuals?: boolean;
  worst?: WorstPoint[];
  /** What was measured in the pictures, once poses are solved: corners or edges. */
  part?: string;
}

const WORDS = { taken: "", used: "", left_out: words("left out"), aside: words("set aside") };

/** The poses one beside the other, the picture of one of them, and the way to set it aside. */
export function PoseView({ poses, shown, onShow, residuals = false, worst = [], part = words("Edges") }: PoseViewProps) {
  const pose = poses.find(({ number }) => number === shown) ?? poses[poses.length - 1];
  if (!pose) return null;
  return (
    <div className={styles.view}>
      {poses.length > 1 && (
        <div className={styles.strip}>
          <div className={styles.poses} role="group" aria-label={t("Poses")}>
            {poses.map(({ number, state, note }) => (
              <button
                key={number}
                type="button"
                className={styles.pose}
                aria-pressed={number === pose.number}
                aria-label={[t("Pose {n}", { n: number }), t(WORDS[state])].filter(Boolean).join(", ")}
                data-state={state}
                onClick={() => onShow(number)}
              >
                {number}
                {note !== "" && state !== "aside" && <QualityMark quality="attention" size="1rem" />}
              </button>
            ))}
          </div>
          <p className={styles.told}>{told(pose, part)}</p>
          {pose.action && <SetAside pose={pose} />}
        </div>
      )}
      <StillImage {...pose} residuals={residuals} worst={worst.filter((w) => w.pose === pose.number)} />
    </div>
  );
}

/** Set aside, or take back; why not, where it cannot be done. */
export function SetAside({ pose }: { pose: PosePicture }) {
  const { action } = pose;
  if (!action) return null;
  return (
    <PressButton
      key={action.name}
      disabled={!action.enabled}
      why={action.why_not}
      onPress={() => sendFlow(action.name, action.args)}
    >
      {action.label}
    </PressButton>
  );
}

function told({ number, note, edges_rms_px, off_um }: PosePicture, part: string): string {
  if (note) return bound(`${note.replace(/\.$/, "")}.`);
  if (edges_rms_px === null || off_um === null) return t("Pose {n}", { n: number });
  return bound(t("{part} {px} px rms, {off} off the others", { part: t(part), px: figures(edges_rms_px, 3), off: measured(off_um, "µm") }));
}
