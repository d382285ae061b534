import { sendCommand, setValue } from "../../api/guideCommands";
import type { PerformanceFile, PerformanceView } from "../../api/wire";
import { Chips } from "../../controls/Chips";
import { t } from "../../state/language";
import styles from "../PerformancePage.module.css";
import choice from "../plan/ArtefactChoice.module.css";
import type { Kind } from "../session/kind";
import { ArticulationList } from "../sphere/ArticulationList";
import { LengthErrors } from "./LengthErrors";
import { LengthPlaces } from "./LengthPlaces";

/** The test of lengths. */
export const lengths: Kind = {
  label: "ui-lengths",
  title: "ui-length-test",
  about: "ui-lengths-first-text",
  needs: "ui-lengths-need",
  scans: false,
  gauge: "ui-length-standard",
  noGauge: ["ui-no-length-standard-yet", "ui-put-length-standard-into-folder"],
  Choices,
  sized: true,
  Picture,
  Result: ({ view: { picture } }) => picture.lengths && <LengthErrors {...picture.lengths} />,
  Record,
};

/** Lengths by touch alone, or by scan, too; of a standard without spheres, why not. */
function Choices({ view }: { view: PerformanceView }) {
  const title = t("ui-how-lengths-are-measured");
  return (
    <section>
      <h3 className={choice.heading}>{title}</h3>
      {view.why_no_scans ? (
        <p className={choice.text}>
          {t("ui-by-touch")}. {view.why_no_scans}
        </p>
      ) : (
        <>
          <p className={choice.text}>{t("ui-by-scan-takes-three-scans")}</p>
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

function Picture({ view: { picture, busy } }: { view: PerformanceView }) {
  const { lengths } = picture;
  if (!lengths) return null;
  const stopped = busy === null && !lengths.scans.some(({ state }) => state === "scanning");
  const [first] = lengths.scans;
  const scans = first && t("ui-scans-of-the-bar-in-place", { place: first.place });
  return (
    <div className={styles.step}>
      <div className={styles.drawings}>
        <LengthPlaces {...lengths} done={lengths.scanned ? "ui-done" : "ui-place-done"} />
        {scans && (
          <section className={styles.scans}>
            <h3 className={styles.name}>{scans}</h3>
            <ArticulationList
              label={scans}
              done="ui-scan-accepted"
              lines={lengths.scans}
              onRepeat={stopped ? (repeat) => void sendCommand("performance", "begin_scan", { repeat }) : undefined}
            />
          </section>
        )}
        <LengthErrors {...lengths} />
      </div>
      <ArticulationList
        label={t("ui-places")}
        lines={lengths.places.map((place) => ({
          ...place,
          text: place.scans > 0 ? t("ui-lengths-and-scans-done-of", place) : t("ui-lengths-done-of", place),
        }))}
      />
    </div>
  );
}

type LengthPoints = NonNullable<PerformanceFile["lengths"]>;

/** The errors by touch and those by scan, as far as there are. */
function Record({ file }: { file: PerformanceFile }) {
  const lengths = file.lengths ?? [];
  const scanned = lengths.filter(({ by }) => by === "scan");
  const touched = lengths.filter(({ by }) => by !== "scan");
  return lengths.length > 0 && <LengthErrors touched={errorsOf(touched)} scanned={errorsOf(scanned)} />;
}

function errorsOf(errors: LengthPoints) {
  return errors.length > 0 ? { errors, limits: limitsOf(errors) } : null;
}

/** The lengths of the standard, with the limits that they were judged by. */
function limitsOf(lengths: LengthPoints) {
  const limits = new Map(lengths.map(({ length_mm, limit_um }) => [length_mm, limit_um ?? null]));
  return [...limits]
    .map(([length_mm, limit_um]) => ({ length_mm, limit_um }))
    .sort((a, b) => a.length_mm - b.length_mm);
}
