import { SegmentedControl } from "@mantine/core";
import { useState } from "react";

import type { Picture } from "../api/types";
import { StillImage } from "../image/StillImage";
import { Budget } from "./Budget";
import { KeyFigures } from "./KeyFigures";
import { Numbers } from "./Numbers";
import { ResidualObject } from "./ResidualObject";
import styles from "./ResultPicture.module.css";
import { UncertaintyMap } from "./UncertaintyMap";

type ResultView = Extract<Picture, { kind: "result" }>;

const TABS = [
  { value: "object", label: "Object" },
  { value: "image", label: "Picture" },
  { value: "map", label: "Map" },
  { value: "budget", label: "Error budget" },
  { value: "numbers", label: "Numbers" },
];

/** The result as pictures first; the table is one tap away. */
export function ResultPicture({ picture }: { picture: ResultView }) {
  const [tab, setTab] = useState("object");
  return (
    <div className={styles.picture}>
      <div className={styles.tabs}>
        <SegmentedControl
          value={tab}
          onChange={setTab}
          data={TABS}
          size="md"
          radius="md"
          aria-label="What to look at"
          classNames={{ root: styles.control ?? "", label: styles.tab ?? "", indicator: styles.indicator ?? "" }}
        />
      </div>
      <div className={styles.shown}>
        {tab === "object" && <ResidualObject block={picture.block} points={picture.points} />}
        {tab === "image" && <StillImage {...picture} residuals />}
        {tab === "map" && (
          <UncertaintyMap
            points={picture.result.map}
            width_px={picture.width_px}
            height_px={picture.height_px}
          />
        )}
        {tab === "budget" && <Budget result={picture.result} />}
        {tab === "numbers" && <Numbers result={picture.result} />}
      </div>
      <KeyFigures result={picture.result} />
    </div>
  );
}
