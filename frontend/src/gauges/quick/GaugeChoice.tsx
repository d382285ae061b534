import { setValue } from "../../api/guideCommands";
import type { GaugeOption } from "../../api/wire";
import { EmptyState } from "../../controls/EmptyState";
import { ChoiceGroup } from "../../flow/ChoiceGroup";
import choice from "../../flow/ChoicesPicture.module.css";
import { t } from "../../state/language";
import { GaugeDrawing } from "../plan/GaugeDrawing";

/** Which gauge is clamped on the table. */
export function GaugeChoice({ gauges, gauge }: { gauges: GaugeOption[]; gauge: string }) {
  if (gauges.length === 0) {
    return (
      <EmptyState
        picture={<GaugeDrawing shape="sphere" />}
        title={t("ui-no-gauge-yet")}
        text={t("ui-put-datasheet-plate-sphere-into-folder")}
      />
    );
  }
  const chosen = gauges.find(({ id }) => id === gauge);
  return (
    <div className={choice.picture}>
      <div className={choice.choices}>
        <ChoiceGroup
          title={t("ui-gauge")}
          options={gauges}
          selected={gauge}
          onChoose={(id) => void setValue("verify", "choose_gauge", { id })}
        />
      </div>
      <div className={choice.drawing}>
        <GaugeDrawing shape={chosen?.shape ?? null} />
      </div>
    </div>
  );
}
