import styles from "./Charts.module.css";
import { LinesChart } from "./LinesChart";
import type { DisplayedVerification } from "./verification";

/** The figures from cloud to cloud, with their limits. */
export function OverClouds({ verification }: { verification: DisplayedVerification }) {
  const labels = verification.clouds.map(({ number }) => `${number}`);
  return (
    <div className={styles.charts}>
      {verification.figures
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
