import { sendVerify } from "../api/verifyCommands";
import type { GaugeOption } from "../api/verifyTypes";
import choice from "../flow/ChoicesPicture.module.css";
import { EmptyState } from "../parts/EmptyState";
import { bound } from "../parts/format";
import { CheckIcon } from "../parts/icons";
import { t } from "../state/language";
import { isolated } from "../state/isolated";
import { GaugeDrawing } from "./GaugeDrawing";

/** Which gauge is clamped on the table. */
export function GaugeChoice({ gauges, gauge }: { gauges: GaugeOption[]; gauge: string }) {
  if (gauges.length === 0) {
    return (
      <EmptyState
        picture={<GaugeDrawing shape="sphere" />}
        title={t("No gauge yet")}
        text={t("Put the paper of a plate or a sphere into the data folder's gauges, as a nominal with its size, its certificate and its limits. It appears here at once.")}
      />
    );
  }
  const chosen = gauges.find(({ id }) => id === gauge);
  return (
    <div className={choice.picture}>
      <div className={choice.choices}>
        <section className={choice.group}>
          <h3 className={choice.heading}>{t("Gauge")}</h3>
          <div role="radiogroup" aria-label={t("Gauge")} className={choice.options}>
            {gauges.map((option) => (
              <button
                key={option.id}
                type="button"
                role="radio"
                aria-checked={option.id === gauge}
                className={choice.option}
                onClick={() => void (option.id === gauge || sendVerify("choose_gauge", { id: option.id }))}
              >
                <span className={choice.tick}>{option.id === gauge && <CheckIcon size="1.125rem" />}</span>
                <span>
                  <span className={choice.label}>{isolated(option.label)}</span>
                  <span className={choice.detail}>{bound(option.detail)}</span>
                </span>
              </button>
            ))}
          </div>
        </section>
      </div>
      <div className={choice.block} style={{ alignItems: "center", justifyContent: "center" }}>
        <GaugeDrawing shape={chosen?.shape ?? null} />
      </div>
    </div>
  );
}
