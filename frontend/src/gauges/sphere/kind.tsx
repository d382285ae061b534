import { sendCommand, setValue } from "../../api/guideCommands";
import type { PerformanceView } from "../../api/wire";
import { Chips } from "../../controls/Chips";
import { t } from "../../state/language";
import { CertificateUpload } from "../exchange/CertificateUpload";
import styles from "../PerformancePage.module.css";
import choice from "../plan/ArtefactChoice.module.css";
import type { Kind } from "../session/kind";
import { ArticulationList } from "./ArticulationList";
import { SphereMap } from "./SphereMap";

/** The test on one sphere. */
export const sphere: Kind = {
  label: "ui-one-sphere",
  title: "ui-test-the-performance",
  about: "ui-performance-first-text",
  needs: "ui-performance-needs",
  scans: true,
  drawing: { shape: "sphere", touching: true, scanning: true },
  Before: CertificateUpload,
  gauge: "ui-test-sphere",
  noGauge: ["ui-no-gauge-yet", "ui-put-datasheet-plate-sphere-into-folder"],
  Choices,
  sized: true,
  Picture,
};

function Choices({ view }: { view: PerformanceView }) {
  const title = t("ui-positions-of-the-sphere");
  return (
    <>
      <CertificateUpload />
      <section>
        <h3 className={choice.heading}>{title}</h3>
        <Chips
          label={title}
          options={[
            { value: 1, label: t("ui-one-position") },
            { value: 2, label: t("ui-two-positions") },
          ]}
          value={view.positions}
          onChange={(number) => void setValue("performance", "set_positions", { number })}
        />
      </section>
    </>
  );
}

function Picture({ view: { picture, step, busy } }: { view: PerformanceView }) {
  const repeats = step !== "location" && busy === null;
  return (
    <div className={styles.step}>
      <SphereMap picture={picture} />
      {picture.articulations.length > 0 && (
        <ArticulationList
          label={t("ui-articulations")}
          lines={picture.articulations}
          onRepeat={
            repeats ? (articulation) => void sendCommand("performance", "begin_scan", { articulation }) : undefined
          }
        />
      )}
    </div>
  );
}
