import { sendCommand } from "../api/guideCommands";
import type { GaugeOption } from "../api/wire";
import choice from "../flow/ChoicesPicture.module.css";
import { EmptyState } from "../parts/EmptyState";
import { CheckIcon } from "../parts/icons";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { GaugeDrawing } from "./GaugeDrawing";

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
        <section className={choice.group}>
          <h3 className={choice.heading}>{t("ui-gauge")}</h3>
          <div role="radiogroup" aria-label={t("ui-gauge")} className={choice.options}>
            {gauges.map((option) => (
              <button
                key={option.id}
                type="button"
                role="radio"
                aria-checked={option.id === gauge}
                className={choice.option}
                onClick={() => void (option.id === gauge || sendCommand("verify", "choose_gauge", { id: option.id }))}
              >
                <span className={choice.tick}>{option.id === gauge && <CheckIcon size="1.125rem" />}</span>
                <span>
                  <span className={choice.label}>{isolated(option.label)}</span>
                  <span className={choice.detail}>{option.detail}</span>
                </span>
              </button>
            ))}
          </div>
        </section>
      </div>
      <div style={{ alignItems: "center", justifyContent: "center" }}>
        <GaugeDrawing shape={chosen?.shape ?? null} />
      </div>
    </div>
  );
}
