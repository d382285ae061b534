import { t } from "../state/language";
import styles from "./SeatIllustration.module.css";

const SHOULDER = [150, 250] as const;
const SEAT = [440, 330] as const;
const POSTURES = [
  { elbow: [222, 96], wrist: [388, 196], state: "past" },
  { elbow: [352, 110], wrist: [500, 214], state: "past" },
  { elbow: [284, 84], wrist: [444, 192], state: "now" },
] as const;

/** An arm that swings about its tip, which stays in a seat. */
export function SeatIllustration() {
  return (
    <div className={styles.illustration}>
      <svg viewBox="0 0 620 400" role="img" aria-label={t("ui-arm-swings-side-side-while-tip")}>
        <path className={styles.ground} d="M40 362h540" />
        <path className={styles.base} d="M112 362v-26h20v-76h36v76h20v26z" />
        <path className={styles.base} d="M404 362l14-30h44l14 30z" />
        <path className={styles.sweep} d="M226 62C264 36 322 36 358 70" />
        {POSTURES.map(({ elbow, wrist, state }) => (
          <g key={elbow.join()} className={styles.posture} data-state={state}>
            <path d={`M${SHOULDER.join(" ")}L${elbow.join(" ")}L${wrist.join(" ")}`} />
            <path className={styles.stylus} d={`M${wrist.join(" ")}L${SEAT.join(" ")}`} />
            <circle cx={elbow[0]} cy={elbow[1]} r={15} />
            <circle cx={wrist[0]} cy={wrist[1]} r={11} />
          </g>
        ))}
        <circle className={styles.joint} cx={SHOULDER[0]} cy={SHOULDER[1]} r={18} />
        <circle className={styles.tip} cx={SEAT[0]} cy={SEAT[1]} r={9} />
      </svg>
    </div>
  );
}
