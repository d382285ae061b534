import { useRef, useState } from "react";
import { Segments } from "../controls/Segments";
import { PoseView } from "../image/PoseView";
import { t } from "../state/language";
import { useLook } from "../state/useLook";
import { Budget } from "./Budget";
import { KeyFigures } from "./KeyFigures";
import { Numbers } from "./Numbers";
import { partOf } from "./names";
import { ResidualObject } from "./ResidualObject";
import styles from "./ResultPicture.module.css";
import { UncertaintyMap } from "./UncertaintyMap";
import type { ResultView } from "./view";

const TABS = [
  { value: "object", label: "ui-object" },
  { value: "image", label: "ui-poses" },
  { value: "map", label: "ui-map" },
  { value: "budget", label: "ui-error-budget" },
  { value: "numbers", label: "ui-numbers" },
] as const;

/** The result: pictures first, the table one tap away. */
export function ResultPicture({ picture }: { picture: ResultView }) {
  const { result, poses } = picture;
  const place = useRef<HTMLDivElement>(null);
  const [tab, setTab] = useState("object");
  const [pose, setPose] = useState(result.shown_pose);
  useLook((requested) => {
    setPose(requested);
    setTab("image");
    place.current?.scrollIntoView({ block: "nearest" });
  });
  return (
    <div ref={place} className={styles.picture} data-stale={picture.stale || undefined}>
      <div className={styles.tabs}>
        <Segments
          value={tab}
          onChange={setTab}
          options={TABS.map(({ value, label }) => ({ value, label: t(label) }))}
          label={t("ui-view")}
        />
      </div>
      <div className={styles.content} tabIndex={0}>
        {tab === "object" && <ResidualObject object={picture.object} points={picture.points} worst={result.worst} />}
        {tab === "image" && (
          <PoseView
            poses={poses}
            selected={pose}
            onShow={setPose}
            residuals
            worst={result.worst}
            part={partOf(picture.object)}
          />
        )}
        {tab === "map" && poses[0] && (
          <UncertaintyMap result={result} width_px={poses[0].width_px} height_px={poses[0].height_px} />
        )}
        {tab === "budget" && <Budget result={result} />}
        {tab === "numbers" && <Numbers result={result} poses={poses} object={picture.object} />}
      </div>
      <KeyFigures result={result} object={picture.object} />
    </div>
  );
}
