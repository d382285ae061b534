import type { BlockDesignView, Problem } from "../api/wire";
import { Busy } from "../controls/Progress";
import forms from "../datasheets/Datasheets.module.css";
import { drawn } from "../datasheets/drawn";
import { LaserOnBlock } from "../object/LaserOnBlock";
import { ObjectDrawing } from "../object/ObjectDrawing";
import { t } from "../state/language";
import styles from "./Design.module.css";

interface BlockResultProps {
  design: BlockDesignView | null;
  /** It is that of the present numbers. */
  isCurrent: boolean;
  /** The present numbers can be asked for. */
  isWanted: boolean;
  problem: Problem | null;
  share: number;
  step: string;
  /** Why nothing is asked for. */
  barred: string;
}

/** The block under the laser, its sizes and what it is good for. */
export function BlockResult({ design, isCurrent, isWanted, problem, share, step, barred }: BlockResultProps) {
  const block = design && drawn("block", JSON.parse(design.document) as Record<string, unknown>);
  return (
    <>
      <div className={styles.state}>
        {barred && <p className={styles.refused}>{barred}</p>}
        {problem && (
          <p className={styles.refused} role="alert">
            {problem.detail} {problem.remedy}
          </p>
        )}
        {isWanted && !isCurrent && !problem && <Busy text={step || t("ui-block-is-designed")} fraction={share} />}
      </div>
      {design && block?.kind === "block" ? (
        <>
          <div className={forms.drawing} data-stale={!isCurrent || undefined}>
            <ObjectDrawing object={block} face={null} label={t("ui-block-under-the-laser")}>
              {(view) => <LaserOnBlock block={block} standoff_mm={design.standoff_mm} view={view} />}
            </ObjectDrawing>
          </div>
          <Figures design={design} isCurrent={isCurrent} />
        </>
      ) : (
        <p className={forms.none}>{t("ui-block-follows-the-numbers")}</p>
      )}
    </>
  );
}

function Figures({ design, isCurrent }: { design: BlockDesignView; isCurrent: boolean }) {
  return (
    <div className={styles.results} data-stale={!isCurrent || undefined}>
      <table>
        <caption>{t("ui-accuracy-of-a-scanned-point")}</caption>
        <thead>
          <tr>
            <th scope="col">{t("ui-block-column")}</th>
            <th scope="col">{t("ui-one-pose")}</th>
            <th scope="col">{t("ui-eight-poses")}</th>
          </tr>
        </thead>
        <tbody>
          {design.accuracies.map(({ made, one_pose, eight_poses }) => (
            <tr key={made}>
              <th scope="row">{made}</th>
              <td>{one_pose}</td>
              <td>{eight_poses}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <table>
        <caption>{t("ui-proposed-block")}</caption>
        <tbody>
          {design.figures.map(({ name, value }) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              <td>{value}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
