import { type ReactNode, useEffect, useId, useRef, useState } from "react";
import { SHORTCUTS } from "../guidance/shortcuts";
import { useBarred } from "../state/control";
import { useElapsed } from "../state/freshness";
import look from "./Control.module.css";
import { measured } from "./lengths";
import styles from "./PressButton.module.css";

interface PressButtonProps {
  children: ReactNode;
  onPress: () => Promise<void> | void;
  kind?: "primary" | "secondary" | "quiet";
  disabled?: boolean;
  /** Why it is disabled, on the button itself. */
  why?: string;
  describedBy?: string | undefined;
  /** The shortcut that presses it; the main act has one by itself. */
  keys?: string | undefined;
  /** It changes nothing at the station: viewers may press it. */
  free?: boolean;
}

/** Two presses within this time count as one (gloves). */
const BOUNCE_MS = 350;

const pause = (ms: number) => new Promise<void>((resolve) => setTimeout(resolve, ms));

/**
 * A button for gloves: large; acts once even if the press bounces; ignores presses just after it has
 * appeared under the finger, and repeats of a key; counts the seconds while its
 * answer is pending. Enter, which barcode scanners and elbows send unintentionally,
 * starts nothing at the station; the space bar does.
 */
export function PressButton(props: PressButtonProps) {
  const { children, onPress, kind = "secondary", describedBy, free = false } = props;
  const keys = kind === "primary" ? SHORTCUTS.main.keys : props.keys;
  const barred = useBarred();
  const bar = free ? "" : barred;
  const disabled = bar !== "" || (props.disabled ?? false);
  const reason = bar && kind === "primary" ? bar : (props.why ?? "");
  const why = disabled ? reason : "";
  const whyId = useId();
  const labelId = useId();
  const [waiting, setWaiting] = useState(true);
  const [asking, setAsking] = useState(false);
  const busy = useRef(true);
  const elapsed_s = useElapsed(asking);

  useEffect(() => {
    const timer = setTimeout(() => {
      busy.current = false;
      setWaiting(false);
    }, BOUNCE_MS);
    return () => clearTimeout(timer);
  }, []);

  const press = async () => {
    if (busy.current || disabled) return;
    busy.current = true;
    setWaiting(true);
    setAsking(true);
    await Promise.all([onPress(), pause(BOUNCE_MS)]);
    busy.current = false;
    setWaiting(false);
    setAsking(false);
  };

  return (
    <button
      type="button"
      className={`${look.button} ${styles.button}`}
      data-kind={kind}
      data-off={disabled || undefined}
      aria-disabled={disabled || waiting || undefined}
      aria-labelledby={why ? labelId : undefined}
      aria-describedby={why ? whyId : describedBy}
      aria-keyshortcuts={keys}
      onClick={() => void press()}
      onKeyDown={(event) => (event.repeat || (event.key === "Enter" && !free)) && event.preventDefault()}
    >
      <span id={labelId} className={styles.label}>
        {children}
      </span>
      {why && (
        <span id={whyId} className={styles.why}>
          {why}
        </span>
      )}
      {elapsed_s > 0.6 && <span className={styles.wait}>{measured(elapsed_s, "s")}</span>}
    </button>
  );
}
