import { markWeak, showArm } from "../api/viewCommands";
import { useBarred } from "../state/control";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { ColourPanel } from "./ColourPanel";
import styles from "./ScansPanel.module.css";

/** What the 3D view shows, and by which colours; for all viewers. */
export function DisplayPanel() {
  const content = useLive((s) => s.view?.content);
  return (
    <>
      <Switch name={t("ui-arm-and-sensor")} on={content?.arm_shown ?? true} onPress={showArm} />
      <Switch name={t("ui-mark-weak-places")} on={content?.weak_shown ?? true} onPress={markWeak} />
      <ColourPanel />
    </>
  );
}

function Switch({ name, on, onPress }: { name: string; on: boolean; onPress: (on: boolean) => Promise<boolean> }) {
  const barred = useBarred() !== "";
  return (
    <button
      type="button"
      role="switch"
      aria-checked={on}
      aria-disabled={barred || undefined}
      className={styles.switch}
      onClick={() => !barred && void onPress(!on)}
    >
      <span className={styles.box} aria-hidden="true" />
      <span className={styles.name}>{name}</span>
    </button>
  );
}
