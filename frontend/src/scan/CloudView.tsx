import { type ReactNode, type RefObject, type SyntheticEvent, useEffect, useState } from "react";
import { addressOf } from "../state/base";

import { t, useLanguage } from "../state/language";
import { getState } from "../state/store";
import { useUnits } from "../state/units";
import styles from "./CloudView.module.css";
import { useDrawing } from "./drawing";
import { controlsOf, hasScene, keepAboveTable } from "./viewCamera";

/** Only the picture of the 3D view's page is shown, on the background of this page. */
const PICTURE_ONLY = `
  html { color-scheme: light !important; }
  body, #root, #root * { background-color: transparent !important; }
  .mantine-Paper-root, .mantine-Notifications-root { display: none !important; }
`;

/** After this time the picture is shown as it is. */
const LATEST_MS = 20_000;

interface CloudViewProps {
  /** It tells the station the viewpoint of this page. */
  viewKey: string;
  frame: RefObject<HTMLIFrameElement | null>;
  /** Overlay on the picture. */
  children?: ReactNode;
}

/** The clouds in the arm frame, drawn by the station's own 3D view. */
export function CloudView({ viewKey, frame, children }: CloudViewProps) {
  const [page, setPage] = useState<Window | null>(null);
  const [ready, setReady] = useState(false);
  const { thousands, watch } = useDrawing();
  const language = useLanguage();
  const labels = `${useUnits() === "inch" ? "-inch" : ""}${language === "en" ? "" : `-${language}`}`;
  // drawn only once the station's data are there, some time after the page
  useEffect(() => {
    if (!page) return;
    const began = performance.now();
    const timer = setInterval(() => {
      const controls = controlsOf(page);
      if (!(controls && hasScene(page)) && performance.now() - began < LATEST_MS) return;
      clearInterval(timer);
      if (controls) keepAboveTable(controls, () => getState().view?.content.floor_mm ?? 0);
      setReady(true);
    }, 100);
    return () => clearInterval(timer);
  }, [page]);
  const prepare = ({ currentTarget }: SyntheticEvent<HTMLIFrameElement>) => {
    const content = currentTarget.contentDocument;
    const style = content?.createElement("style");
    if (!content || !style) return;
    style.textContent = PICTURE_ONLY;
    content.head.append(style);
    setReady(false);
    setPage(currentTarget.contentWindow);
    if (currentTarget.contentWindow) watch({ window: currentTarget.contentWindow });
  };
  return (
    <div className={styles.view} data-cloud>
      {!ready && (
        <p className={styles.waiting} role="status">
          <span className={styles.turning} aria-hidden="true" />
          {t("ui-the-3d-view-is-loading")}
        </p>
      )}
      <iframe
        ref={frame}
        className={styles.frame}
        data-ready={ready || undefined}
        src={addressOf(`/viewer/${viewKey}${thousands ? `-${thousands}` : ""}${labels}/`)}
        title={t("ui-live-cloud-of-points")}
        onLoad={prepare}
      />
      {thousands && <p className={styles.fewer}>{t("ui-fewer-points-this-browser-renders-slowly")}</p>}
      {children}
    </div>
  );
}
