import { useEffect, useState } from "react";

import { QualityMark } from "../parts/QualityMark";
import { useLive } from "../state/store";
import styles from "./LastEvent.module.css";

const SHOWN_MS = 5000;

/** What just happened, for a moment: "Point 8 on the front face, +12 µm". */
export function LastEvent() {
  const event = useLive((s) => s.event);
  const [hidden, setHidden] = useState<number | null>(event?.id ?? null);
  useEffect(() => {
    if (!event) return;
    const timer = setTimeout(() => setHidden(event.id), SHOWN_MS);
    return () => clearTimeout(timer);
  }, [event]);
  const shown = event && event.id !== hidden && event.text ? event : null;
  return (
    <div className={styles.place} aria-live="polite">
      {shown && (
        <div className={styles.event}>
          <QualityMark quality={shown.quality} size="1.25rem" />
          <span>{shown.text}</span>
        </div>
      )}
    </div>
  );
}
