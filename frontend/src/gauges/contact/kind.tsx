import { setValue } from "../../api/guideCommands";
import type { ArticulationLine, PerformanceView } from "../../api/wire";
import { ChoiceGroup } from "../../flow/ChoiceGroup";
import { t } from "../../state/language";
import { LengthPlaces } from "../length/LengthPlaces";
import styles from "../PerformancePage.module.css";
import { GaugeDrawing } from "../plan/GaugeDrawing";
import { type Kind, withoutOption } from "../session/kind";
import { ArticulationList } from "../sphere/ArticulationList";

/** The contact tests: a master sphere, seats and a ball bar. */
export const contact: Kind = {
  label: "ui-contact-test",
  title: "ui-contact-test-title",
  about: "ui-contact-about",
  needs: "ui-contact-needs",
  scans: false,
  drawing: { shape: "sphere", touching: true },
  gauge: "ui-master-sphere",
  without: "ui-without-a-sphere",
  Choices,
  sized: true,
  Picture,
};

function Choices({ view }: { view: PerformanceView }) {
  return (
    <ChoiceGroup
      title={t("ui-ball-bar")}
      options={[...view.bars, withoutOption(t("ui-without-a-ball-bar"), t("ui-its-figures-are-left-out"))]}
      selected={view.bar}
      onChoose={(id) => void setValue("performance", "choose_bar", { id })}
    />
  );
}

/** Where seats or bar stand, or the sphere, and what each measurement has shown. */
function Picture({ view: { picture, step } }: { view: PerformanceView }) {
  const { contact } = picture;
  if (!contact) return null;
  return (
    <div className={styles.step}>
      <div className={styles.drawings}>
        {contact.places.length > 0 ? <LengthPlaces {...contact} alone /> : <GaugeDrawing shape="sphere" touching />}
      </div>
      <ArticulationList
        label={t(step === "bar" ? "ui-placements" : step === "seats" ? "ui-seats" : "ui-measurements")}
        lines={step === "bar" ? newestFirst(contact.lines) : contact.lines}
      />
    </div>
  );
}

/** What is touched now, then what was touched last, then what is to do: the first are in sight below the drawing. */
function newestFirst(lines: ArticulationLine[]) {
  const inState = (wanted: ArticulationLine["state"]) => lines.filter(({ state }) => state === wanted);
  return [...inState("now"), ...inState("done").reverse(), ...inState("todo")];
}
