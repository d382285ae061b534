import type { PatchMark, PerformancePicture } from "../../api/wire";
import { t } from "../../state/language";
import keys from "../session/MapKey.module.css";
import styles from "./SphereMap.module.css";

const RINGS_DEG = [22.5, 45, 67.5, 90];
const PATCH_DEG = 8;
/** So many missing patches are named in words, too. */
const FEW = 8;

/** The sphere as seen from above, the arm at the bottom: places to touch, or patches to scan. */
export function SphereMap({ picture }: { picture: PerformancePicture }) {
  const { places, patches, tip_deg } = picture;
  const missing = patches.filter(({ covered }) => !covered).map(({ number }) => number);
  return (
    <figure className={styles.map}>
      <svg className={styles.drawing} viewBox="-118 -118 236 236" role="img" aria-label={t("ui-sphere-from-above")}>
        <circle className={styles.sphere} r={90} />
        {RINGS_DEG.map((ring) => (
          <circle key={ring} className={styles.ring} r={ring} />
        ))}
        {patches.map((patch) => (
          <Patch key={patch.number} patch={patch} />
        ))}
        {places.map(({ number, right_deg, away_deg, state }) => (
          <g key={number} className={styles.place} data-state={state} data-place={number}>
            <circle cx={right_deg} cy={-away_deg} r={state === "next" ? 8.5 : 7} />
            <text x={right_deg} y={-away_deg}>
              {number}
            </text>
          </g>
        ))}
        {tip_deg && places.length > 0 && <circle className={styles.tip} cx={tip_deg[0]} cy={-tip_deg[1]} r={3.5} />}
      </svg>
      <figcaption className={styles.caption}>
        <span>{t("ui-seen-from-above-arm-below")}</span>
        {places.length > 0 && (
          <span className={keys.key}>
            <i data-key="next" /> {t("ui-place-next")} <i data-key="done" /> {t("ui-place-done")} <i data-key="tip" />{" "}
            {t("ui-place-tip")}
          </span>
        )}
        {patches.length > 0 && (
          <span className={keys.key}>
            <i data-key="covered" /> {t("ui-patch-covered")} <i data-key="partly" /> {t("ui-patch-partly")}{" "}
            <i data-key="open" /> {t("ui-patch-open")}
          </span>
        )}
        {missing.length > 0 && (
          <span className={styles.missing} data-missing={missing.length}>
            {missing.length > FEW
              ? t("ui-patches-missing-many", { count: missing.length })
              : t("ui-patches-missing", { count: missing.length, patches: missing.join(", ") })}
          </span>
        )}
      </figcaption>
    </figure>
  );
}

function Patch({ patch }: { patch: PatchMark }) {
  const state = patch.covered ? "covered" : patch.points > 0 ? "partly" : "open";
  return (
    <g className={styles.patch} data-state={state} data-patch={patch.number}>
      <circle cx={patch.right_deg} cy={-patch.away_deg} r={PATCH_DEG} />
      {state === "partly" && (
        <circle
          className={styles.share}
          cx={patch.right_deg}
          cy={-patch.away_deg}
          r={PATCH_DEG}
          pathLength={1}
          transform={`rotate(-90 ${patch.right_deg} ${-patch.away_deg})`}
          style={{ strokeDasharray: `${patch.share} 1` }}
        />
      )}
      <text x={patch.right_deg} y={-patch.away_deg}>
        {patch.number}
      </text>
      <title>{t("ui-patch-holds", { points: patch.points, frames: patch.frames })}</title>
    </g>
  );
}
