import { sendCommand } from "../api/guideCommands";
import type { FeatureMark, PartView } from "../api/wire";
import { CheckIcon } from "../controls/icons";
import { QualityMark } from "../controls/QualityMark";
import { t } from "../state/language";
import styles from "./FeatureChips.module.css";
import { OUTCOME_QUALITY, OUTCOMES } from "./outcomes";

/** The features of the step, each with its count or its word; choosing one takes it in hand. */
export function FeatureChips({ view }: { view: PartView }) {
  const datums = view.step === "align";
  const features = view.features.filter((mark) => mark.is_datum === datums);
  return (
    <div className={styles.chips} role="group" aria-label={t("ui-part-features")}>
      {features.map((mark) => (
        <button
          key={mark.id}
          type="button"
          className={styles.chip}
          aria-pressed={mark.id === view.feature}
          data-next={mark.is_next || undefined}
          onClick={() => void sendCommand("parts", "choose_feature", { id: mark.id })}
        >
          <span className={styles.title}>
            <span>{mark.id}</span>
            <Mark mark={mark} />
          </span>
          <span className={styles.count}>{textOf(mark)}</span>
        </button>
      ))}
    </div>
  );
}

function Mark({ mark }: { mark: FeatureMark }) {
  if (mark.state === "skipped" || mark.touches < mark.least) return null;
  if (mark.outcome === "none")
    return (
      <span className={styles.done}>
        <CheckIcon size="1rem" />
      </span>
    );
  return <QualityMark quality={OUTCOME_QUALITY[mark.outcome]} size="1.125rem" />;
}

function textOf(mark: FeatureMark): string {
  if (mark.state === "skipped") return t("ui-part-skipped");
  if (mark.outcome !== "none" && mark.touches >= mark.least) return t(OUTCOMES[mark.outcome]);
  return t("ui-part-done-of", { done: mark.touches, all: mark.advised });
}
