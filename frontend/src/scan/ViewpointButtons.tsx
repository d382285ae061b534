import type { Viewpoint } from "../api/types";
import { turnView } from "../api/viewCommands";
import look from "../controls/Control.module.css";
import { SHORTCUTS } from "../guidance/shortcuts";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";
import styles from "./ViewpointButtons.module.css";

const VIEWPOINTS: [Viewpoint, PlainId][] = [
  ["above", "ui-from-above"],
  ["front", "ui-from-the-front"],
  ["side", "ui-from-the-side"],
  ["whole", "ui-whole-cloud"],
];

/** Viewpoints of this page's own 3D view; others keep theirs. */
export function ViewpointButtons({ viewKey }: { viewKey: string }) {
  return (
    <div className={styles.viewpoints} role="group" aria-label={t("ui-viewpoint")}>
      {VIEWPOINTS.map(([viewpoint, words]) => (
        <button
          key={viewpoint}
          aria-keyshortcuts={SHORTCUTS[viewpoint].keys}
          type="button"
          className={`${look.button} ${styles.viewpoint}`}
          onClick={() => void turnView(viewKey, viewpoint)}
        >
          {t(words)}
        </button>
      ))}
    </div>
  );
}
