import { setValue } from "../../api/guideCommands";
import type { PerformanceView } from "../../api/wire";
import { EmptyState } from "../../controls/EmptyState";
import { ChoiceGroup } from "../../flow/ChoiceGroup";
import { t } from "../../state/language";
import { KINDS } from "../kinds";
import { withoutOption } from "../session/kind";
import styles from "./ArtefactChoice.module.css";
import { GaugeDrawing } from "./GaugeDrawing";
import { Limits } from "./Limits";
import { Temperatures } from "./Temperatures";

/** What a test is done on, how, and the limits by the datasheet. */
export function ArtefactChoice({ view }: { view: PerformanceView }) {
  const { gauge, without, drawing, noGauge, Before, Choices } = KINDS[view.test];
  const none = without ? [withoutOption(t(without), t("ui-its-figures-are-left-out"))] : [];
  if (view.gauges.length === 0 && noGauge) {
    const [title, text] = noGauge;
    return (
      <div className={styles.choice}>
        <EmptyState picture={drawing && <GaugeDrawing shape={drawing.shape} />} title={t(title)} text={t(text)} />
        {Before && <Before />}
      </div>
    );
  }
  return (
    <div className={styles.choice}>
      <ChoiceGroup
        title={t(gauge)}
        options={[...view.gauges, ...none]}
        selected={view.gauge}
        onChoose={(id) => void setValue("performance", "choose_gauge", { id })}
      />
      {Choices && <Choices view={view} />}
      <Temperatures view={view} />
      <Limits limits={view.picture.limits} />
    </div>
  );
}
