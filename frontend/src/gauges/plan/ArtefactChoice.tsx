import { setValue } from "../../api/guideCommands";
import type { PerformanceView } from "../../api/wire";
import { ChoiceGroup } from "../../flow/ChoiceGroup";
import { Chips } from "../../parts/Chips";
import { EmptyState } from "../../parts/EmptyState";
import { t } from "../../state/language";
import { CertificateUpload } from "../exchange/CertificateUpload";
import styles from "./ArtefactChoice.module.css";
import { GaugeDrawing } from "./GaugeDrawing";
import { Limits } from "./Limits";
import { Temperatures } from "./Temperatures";

/** What a test is done on, how, and the limits by the datasheet. */
export function ArtefactChoice({ view }: { view: PerformanceView }) {
  if (view.test === "contact") return <ContactChoice view={view} />;
  return <OneArtefact view={view} />;
}

/** The sphere and the bar of a contact test; each may be left out. */
function ContactChoice({ view }: { view: PerformanceView }) {
  const without = (label: string) => ({ id: "", label, detail: t("ui-its-figures-are-left-out"), why_not: "" });
  return (
    <div className={styles.choice}>
      <ChoiceGroup
        title={t("ui-master-sphere")}
        options={[...view.gauges, without(t("ui-without-a-sphere"))]}
        selected={view.gauge}
        onChoose={(id) => void setValue("performance", "choose_gauge", { id })}
      />
      <ChoiceGroup
        title={t("ui-ball-bar")}
        options={[...view.bars, without(t("ui-without-a-ball-bar"))]}
        selected={view.bar}
        onChoose={(id) => void setValue("performance", "choose_bar", { id })}
      />
      <Temperatures view={view} />
      <Limits limits={view.picture.limits} />
    </div>
  );
}

const TITLES = { sphere: "ui-test-sphere", lengths: "ui-length-standard", plane: "ui-plate" } as const;

/** The sphere and its number of positions, the plate, or the length standard. */
function OneArtefact({ view }: { view: PerformanceView }) {
  const sphere = view.test === "sphere";
  if (view.gauges.length === 0 && view.test === "lengths")
    return <EmptyState title={t("ui-no-length-standard-yet")} text={t("ui-put-length-standard-into-folder")} />;
  if (view.gauges.length === 0)
    return (
      <div className={styles.choice}>
        <EmptyState
          picture={<GaugeDrawing shape={sphere ? "sphere" : "plane"} />}
          title={t("ui-no-gauge-yet")}
          text={t("ui-put-datasheet-plate-sphere-into-folder")}
        />
        {sphere && <CertificateUpload />}
      </div>
    );
  return (
    <div className={styles.choice}>
      <ChoiceGroup
        title={t(view.test === "contact" ? "ui-master-sphere" : TITLES[view.test])}
        options={view.gauges}
        selected={view.gauge}
        onChoose={(id) => void setValue("performance", "choose_gauge", { id })}
      />
      {sphere && <CertificateUpload />}
      {sphere && (
        <section>
          <h3 className={styles.heading}>{t("ui-positions-of-the-sphere")}</h3>
          <Chips
            label={t("ui-positions-of-the-sphere")}
            options={[
              { value: 1, label: t("ui-one-position") },
              { value: 2, label: t("ui-two-positions") },
            ]}
            value={view.positions}
            onChange={(number) => void setValue("performance", "set_positions", { number })}
          />
        </section>
      )}
      {view.test === "lengths" && <ByScanChoice view={view} />}
      <Temperatures view={view} />
      <Limits limits={view.picture.limits} />
    </div>
  );
}

/** Lengths by touch alone, or by scan, too; of a standard without spheres, why not. */
function ByScanChoice({ view }: { view: PerformanceView }) {
  const title = t("ui-how-lengths-are-measured");
  return (
    <section>
      <h3 className={styles.heading}>{title}</h3>
      {view.why_no_scans ? (
        <p className={styles.text}>
          {t("ui-by-touch")}. {view.why_no_scans}
        </p>
      ) : (
        <>
          <p className={styles.text}>{t("ui-by-scan-takes-three-scans")}</p>
          <Chips
            label={title}
            options={[
              { value: 0, label: t("ui-by-touch") },
              { value: 1, label: t("ui-by-touch-and-by-scan") },
            ]}
            value={view.by_scan ? 1 : 0}
            onChange={(value) => void setValue("performance", "set_by_scan", { by_scan: value === 1 })}
          />
        </>
      )}
    </section>
  );
}
