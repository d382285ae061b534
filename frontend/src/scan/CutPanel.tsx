import { undoCut } from "../api/viewCommands";
import { PressButton } from "../controls/PressButton";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./CutPanel.module.css";

/** Cuts stray points away: of the view and of saved clouds. */
export function CutPanel({ onDraw }: { onDraw: (outside: boolean) => void }) {
  const some = useLive((s) => (s.view?.scans ?? []).some(({ points_shown }) => points_shown > 0));
  const cuts = useLive((s) => s.view?.cuts ?? 0);
  const gone = useLive((s) => s.view?.content.points_cut ?? 0);
  const why = some ? "" : t("ui-no-cloud-picture-yet-scan-display");
  return (
    <>
      <h2 className={styles.title}>{t("ui-cut-points-away")}</h2>
      <div className={styles.acts}>
        <PressButton onPress={() => onDraw(false)} disabled={!some}>
          {t("ui-cut-what-is-inside")}
        </PressButton>
        <PressButton onPress={() => onDraw(true)} disabled={!some}>
          {t("ui-keep-only-what-is-inside")}
        </PressButton>
        <PressButton onPress={async () => void (await undoCut())} disabled={cuts === 0}>
          {t("ui-undo-the-last-cut")}
        </PressButton>
      </div>
      {why && <p className={styles.note}>{why}</p>}
      <p className={styles.count} role="status">
        {cuts > 0 && t("ui-points-are-cut-away", { n: gone })}
      </p>
      <p className={styles.note}>{t("ui-cuts-leave-the-recording-whole")}</p>
    </>
  );
}
