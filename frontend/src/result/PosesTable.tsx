import type { ObjectGeometry } from "../api/types";
import type { PosePicture } from "../api/wire";
import table from "../controls/DataTable.module.css";
import { figures } from "../controls/format";
import { lengthFigures, unitOf } from "../controls/lengths";
import { ExcludeButton } from "../image/PoseView";
import { t } from "../state/language";
import { lookAtPose } from "../state/store";
import { partOf } from "./names";
import styles from "./PosesTable.module.css";

/** Every pose: how it fits, or why it or its laser line is excluded; with buttons to view and exclude it. */
export function PosesTable({ poses, object }: { poses: PosePicture[]; object: ObjectGeometry }) {
  const acts = poses.some(({ action }) => action);
  return (
    <table className={table.table}>
      <caption className={table.caption}>{t("ui-poses")}</caption>
      <thead>
        <tr>
          <th scope="col">{t("ui-pose")}</th>
          <th scope="col">{t(partOf(object))}, px</th>
          <th scope="col">{t("ui-stripe")}, px</th>
          <th scope="col">
            {t("ui-deviation")}, {unitOf("µm")}
          </th>
          {acts && <th scope="col" aria-label={t("ui-exclude")} />}
        </tr>
      </thead>
      <tbody>
        {poses.map((pose) => (
          <tr key={pose.number} data-excluded={pose.state === "aside" || undefined} className={styles.row}>
            <td>
              <button type="button" className={styles.show} onClick={() => lookAtPose(pose.number)}>
                {t("ui-pose-n", { n: pose.number })}
              </button>
            </td>
            <Figures pose={pose} />
            {acts && (
              <td className={styles.act}>
                <ExcludeButton pose={pose} />
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
        {note || t("ui-not-solved-yet")}
      </td>
    );
  }
  return (
    <>
      <td>{figures(edges_rms_px, 3)}</td>
      <td>{stripe_rms_px === null ? t("ui-left-out") : figures(stripe_rms_px, 3)}</td>
      <td>{lengthFigures(off_um, "µm")}</td>
    </>
  );
}
