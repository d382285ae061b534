import { useElapsed } from "../state/freshness";
import { measured } from "./lengths";
import styles from "./Progress.module.css";

interface BarProps {
  done: number;
  of: number;
  text: string;
}

/** Progress "n of m": as ticks if they can be counted at a glance, otherwise as a bar. */
export function Progress({ done, of, text }: BarProps) {
  const ticks = of > 0 && of <= 40;
  return (
    <div className={styles.progress}>
      <div className={styles.text}>{text}</div>
      <div role="progressbar" aria-valuenow={done} aria-valuemin={0} aria-valuemax={of} aria-label={text}>
        {ticks ? <Ticks done={done} of={of} /> : <Bar share={of > 0 ? done / of : 0} />}
      </div>
    </div>
  );
}

function Ticks({ done, of }: { done: number; of: number }) {
  return (
    <div className={styles.ticks} data-many={of > 20 || undefined}>
      {Array.from({ length: of }, (_, i) => (
        <span key={i} className={styles.tick} data-done={i < done || undefined} />
      ))}
    </div>
  );
}

function Bar({ share }: { share: number }) {
  const percent = Math.min(100, Math.max(0, share * 100));
  return (
    <div className={styles.track}>
      <div className={styles.fill} style={{ width: `${percent}%` }} />
    </div>
  );
}

/** A running job: the share done, or, if unknown, the elapsed seconds. */
export function Busy({ text, fraction }: { text: string; fraction: number | null }) {
  const elapsed_s = useElapsed(true);
  const figure = fraction === null ? measured(elapsed_s, "s") : measured(fraction * 100, "%");
  return (
    <div className={styles.busy} role="status">
      <div className={styles.busyText}>
        <span>{text}</span>
        <span>{figure}</span>
      </div>
      {fraction !== null && <Bar share={fraction} />}
    </div>
  );
}
