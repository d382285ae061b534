import { type ReactNode, type RefObject, type SyntheticEvent, useState } from "react";
import { addressOf } from "../state/base";

import { t } from "../state/language";
import styles from "./CloudView.module.css";
import { useDrawing } from "./drawing";

/** Only the picture of the 3D view's page is shown, on the background of this page. */
const PICTURE_ONLY = `
  html { color-scheme: light !important; }
  body, #root, #root * { background-color: transparent !important; }
  .mantine-Paper-root, .mantine-Notifications-root { display: none !important; }
`;

interface CloudViewProps {
  /** It tells the station the viewpoint of this page. */
  viewKey: string;
  frame: RefObject<HTMLIFrameElement | null>;
  /** Overlay on the picture. */
  children?: ReactNode;
}

/** The clouds in the arm frame, drawn by the station's own 3D view. */
export function CloudView({ viewKey, frame, children }: CloudViewProps) {
  const [ready, setReady] = useState(false);
  const { thousands, watch } = useDrawing();
  const prepare = ({ currentTarget }: SyntheticEvent<HTMLIFrameElement>) => {
    const page = currentTarget.contentDocument;
    const style = page?.createElement("style");
    if (!page || !style) return;
    style.textContent = PICTURE_ONLY;
    page.head.append(style);
    setReady(true);
    if (currentTarget.contentWindow) watch({ window: currentTarget.contentWindow });
  };
  return (
    <div className={styles.view}>
      {!ready && <p className={styles.waiting}>{t("ui-the-3d-view-opens-here")}</p>}
      <iframe
        ref={frame}
        className={styles.frame}
        data-ready={ready || undefined}
        src={addressOf(`/viewer/${viewKey}${thousands ? `-${thousands}` : ""}/`)}
        title={t("ui-live-cloud-of-points")}
        onLoad={prepare}
      />
      {thousands && <p className={styles.fewer}>{t("ui-fewer-points-this-browser-renders-slowly")}</p>}
      {children}
    </div>
  );
}
