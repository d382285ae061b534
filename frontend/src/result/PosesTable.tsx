import type { ObjectGeometry } from "../api/flowTypes";
import type { PosePicture } from "../api/resultTypes";
import { SetAside } from "../image/PoseView";
import { figures } from "../parts/format";
import { lengthFigures, unitOf } from "../parts/lengths";
import table from "../parts/DataTable.module.css";
import { t } from "../state/language";
import { lookAtPose } from "../state/store";
import { partOf } from "./names";
import styles from "./PosesTable.module.css";

/** Every pose that was taken: how it fits, or why it does not count; of a laser line, that it does not; to look at, or to set aside. */
export function PosesTable({ poses, object }: { poses: PosePicture[]; object: ObjectGeometry }) {
  const acts = poses.some(({ action }) => action);
  return (
    <table className={table.table}>
      <caption className={table.caption}>{t("Poses")}</caption>
      <thead>
        <tr>
          <th scope="col">{t("Pose")}</th>
          <th scope="col">{t(partOf(object))}, px</th>
          <th scope="col">{t("Stripe")}, px</th>
          <th scope="col">{t("Off")}, {unitOf("µm")}</th>
          {acts && <th scope="col" aria-label={t("Set aside")} />}
        </tr>
      </thead>
      <tbody>
        {poses.map((pose) => (
          <tr key={pose.number} data-aside={pose.state === "aside" || undefined} className={styles.row}>
            <td>
              <button type="button" className={styles.show} onClick={() => lookAtPose(pose.number)}>
                {t("Pose {n}", { n: pose.number })}
              </button>
            </td>
            <Figures pose={pose} />
            {acts && (
              <td className={styles.act}>
                <SetAside pose={pose} />
              </td>
            )}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Figures({ pose: { note, edges_rms_px, stripe_rms_px, off_um } }: { pose: PosePicture }) {
  if (edges_rms_px === null || off_um === null) {
    return (
      <td colSpan={3} className={styles.note}>
        {note || t("not solved yet")}
      </td>
    );
  }
  return (
    <>
      <td>{figures(edges_rms_px, 3)}</td>
      <td>{stripe_rms_px === null ? t("left out") : figures(stripe_rms_px, 3)}</td>
      <td>{lengthFigures(off_um, "µm")}</td>
    </>
  );
}
