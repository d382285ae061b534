import { useComputedColorScheme } from "@mantine/core";

import styles from "./CloudView.module.css";

/** The live cloud in the arm frame, drawn by the station's own 3D view. */
export function CloudView() {
  const scheme = useComputedColorScheme("light");
  return (
    <div className={styles.view}>
      <p className={styles.waiting}>The 3D view opens here.</p>
      <iframe
        className={styles.frame}
        src={scheme === "dark" ? "/viewer/?darkMode" : "/viewer/"}
        title="Live cloud of points"
      />
    </div>
  );
}
