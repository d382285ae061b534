import styles from "./Charts.module.css";
import { LinesChart } from "./LinesChart";
import type { Shown } from "./shown";

/** How the figures go from cloud to cloud, against their limits. */
export function OverClouds({ shown }: { shown: Shown }) {
  const labels = shown.clouds.map(({ number }) => `${number}`);
  return (
    <div className={styles.charts}>
      {shown.figures
        .filter((figure) => figure.clouds.length === labels.length)
        .map((figure) => (
          <LinesChart
            key={figure.name}
            title={figure.title}
            unit={figure.unit}
            lines={[{ name: figure.title, values: figure.clouds, colour: "var(--accent)" }]}
            labels={labels}
            limit={figure.limit}
            both={["offset", "z_error", "radius_error"].includes(figure.name)}
          />
        ))}
    </div>
  );
}
