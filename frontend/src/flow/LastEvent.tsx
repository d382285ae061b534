import { type ReactNode, useEffect, useState } from "react";

import { QualityMark } from "../controls/QualityMark";
import { type StationEvent, useLive } from "../state/store";
import styles from "./LastEvent.module.css";

const DISPLAY_MS = 5000;

/** Problems are notices, and the next step has its own title. */
function isElsewhere({ kind, quality, text }: StationEvent): boolean {
  return text === "" || kind === "step_done" || quality === "attention" || quality === "bad";
}

/** The last event, shown briefly in the place of the note: "Point 8 on the front face, +12 µm". */
export function LastEvent({ children }: { children: ReactNode }) {
  const event = useLive((s) => s.event);
  const [hidden, setHidden] = useState<number | null>(event?.id ?? null);
  useEffect(() => {
    if (!event) return;
    const timer = setTimeout(() => setHidden(event.id), DISPLAY_MS);
    return () => clearTimeout(timer);
  }, [event]);
  const displayed = event && event.id !== hidden && !isElsewhere(event) ? event : null;
  return (
    <div className={styles.place}>
      <div aria-live="polite">
        {displayed && (
          <p className={styles.event}>
            <QualityMark quality={displayed.quality} size="1.25rem" />
            {displayed.text}
          </p>
        )}
      </div>
      {!displayed && children}
    </div>
  );
}
