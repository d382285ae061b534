import { sendCommand } from "../../api/guideCommands";
import type { PerformanceView } from "../../api/wire";
import { t } from "../../state/language";
import styles from "../PerformancePage.module.css";
import type { Kind } from "../session/kind";
import { ArticulationList } from "../sphere/ArticulationList";
import { PlateMap } from "./PlateMap";

/** The test on a plate. */
export const plane: Kind = {
  label: "ui-plane-test",
  title: "ui-plane-test-title",
  about: "ui-plane-about",
  needs: "ui-plane-needs",
  scans: true,
  drawing: { shape: "plane", scanning: true },
  gauge: "ui-plate",
  noGauge: ["ui-no-gauge-yet", "ui-put-datasheet-plate-sphere-into-folder"],
  sized: false,
  Picture,
};

/** The orientation that is scanned now, or was last, and what each has shown. */
function Picture({ view: { picture, busy } }: { view: PerformanceView }) {
  const lines = picture.articulations;
  const shown = lines.find(({ state }) => state !== "done")?.number ?? lines.length;
  return (
    <div className={styles.step}>
      <PlateMap orientation={shown} />
      <ArticulationList
        label={t("ui-orientations")}
        lines={lines}
        onRepeat={
          busy === null ? (orientation) => void sendCommand("performance", "begin_scan", { orientation }) : undefined
        }
      />
    </div>
  );
}
