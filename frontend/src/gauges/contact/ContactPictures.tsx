import type { ArticulationLine, ContactPicture } from "../../api/wire";
import { t } from "../../state/language";
import { LengthPlaces } from "../length/LengthPlaces";
import styles from "../PerformancePage.module.css";
import { GaugeDrawing } from "../plan/GaugeDrawing";
import { ArticulationList } from "../sphere/ArticulationList";

/** Where seats or bar stand, or the sphere, and what each measurement has shown. */
export function ContactPictures({ contact, step }: { contact: ContactPicture; step: string }) {
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
