import type { PlaceOnMap } from "../api/wire";
import { CloseIcon } from "../controls/icons";
import { measured, signedLength } from "../controls/lengths";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";
import styles from "./ComparePanel.module.css";
import { DECISIONS, Swatch } from "./MapLegend";

const SOURCES: [string, PlainId][] = [
  ["points", "ui-share-of-points"],
  ["encoders", "ui-share-of-encoders"],
  ["calibration", "ui-share-of-calibration"],
  ["arm", "ui-share-of-arm"],
  ["tip", "ui-share-of-tip"],
  ["alignment", "ui-share-of-alignment"],
  ["cad", "ui-share-of-cad"],
];
const HELP: Record<NonNullable<PlaceOnMap["help"]>, PlainId> = {
  "more-passes": "ui-help-more-passes",
  "other-postures": "ui-help-other-postures",
  calibrate: "ui-help-calibrate",
  "identify-arm": "ui-help-identify-arm",
  "scan-more": "ui-help-scan-more",
  "finer-facets": "ui-help-finer-facets",
};
const WORDS = { in: "inside", out: "outside", undecided: "undecided" } as const;

/** What is known of the tapped place of the map. */
export function PlaceCard({ place, onClose }: { place: PlaceOnMap; onClose: () => void }) {
  return (
    <article className={styles.place} aria-label={t("ui-tapped-place")} aria-live="polite">
      <header className={styles.head}>
        <h3 className={styles.name}>{t("ui-tapped-place")}</h3>
        <button type="button" className={styles.close} onClick={onClose} aria-label={t("ui-close-the-place")}>
          <CloseIcon size="1.25rem" />
        </button>
      </header>
      {place.state === "cell" ? <Cell place={place} /> : <p>{t("ui-this-place-was-not-scanned")}</p>}
    </article>
  );
}

function Cell({ place }: { place: PlaceOnMap }) {
  const u = place.standard_uncertainty_um;
  const decision = DECISIONS.find(({ kind }) => kind === WORDS[place.decision]);
  return (
    <>
      <p className={styles.main}>
        {signedLength(place.deviation_um, "µm", 1)}
        <span className={styles.known}>
          {u === null
            ? t("ui-scatter-of-a-point", { scatter: measured(place.scatter_um, "µm", 1) })
            : t("ui-u-of", { u: measured(2 * u, "µm", 1) })}
        </span>
      </p>
      {decision && (
        <p className={styles.decision}>
          <Swatch colours={decision.colours} /> {t(decision.name)}
        </p>
      )}
      {u !== null && <Shares place={place} />}
      {place.help && u !== null && <p className={styles.help}>{t(HELP[place.help])}</p>}
      <p className={styles.note}>
        {t("ui-place-of-cell", {
          x: measured(place.x_mm, "mm", 1),
          y: measured(place.y_mm, "mm", 1),
          z: measured(place.z_mm, "mm", 1),
          points: place.points,
          frames: place.frames,
        })}
      </p>
    </>
  );
}

/** Where its uncertainty comes from, each as U, k = 2. */
function Shares({ place }: { place: PlaceOnMap }) {
  const budget = place.budget_um;
  const largest = Math.max(...Object.values(budget).map(Math.abs), 1e-9);
  const rows = SOURCES.filter(([source]) => Math.abs(budget[source] ?? 0) >= 0.005);
  return (
    <div>
      <p className={styles.note}>{t("ui-u-consists-of")}</p>
      {rows.map(([source, name]) => {
        const share = budget[source] ?? 0;
        return (
          <div key={source} className={styles.share} data-less={share < 0 || undefined}>
            <span>{t(name)}</span>
            <span className={styles.value}>{measured(2 * share, "µm", 1)}</span>
            <span className={styles.track} aria-hidden="true">
              <span className={styles.fill} style={{ width: `${(100 * Math.abs(share)) / largest}%` }} />
            </span>
          </div>
        );
      })}
      {rows.some(([source]) => (budget[source] ?? 0) < 0) && <p className={styles.note}>{t("ui-share-below-zero")}</p>}
    </div>
  );
}
