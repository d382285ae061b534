import type { Health, HealthItem } from "../api/wire";
import rows from "../controls/List.module.css";
import { QualityMark } from "../controls/QualityMark";
import { t } from "../state/language";
import styles from "./Health.module.css";

/** All checks: those that need attention in full, the others in one line each. */
export function Checks({ health }: { health: Health }) {
  const wanting = health.items.filter((item) => item.quality === "bad" || item.quality === "attention");
  const fine = health.items.filter((item) => item.quality === "good" || item.quality === "neutral");
  return (
    <section className={styles.section} aria-label={t("ui-health")}>
      <h1 className={rows.heading}>{titleOf(wanting)}</h1>
      {wanting.length > 0 && (
        <ul className={styles.wanting}>
          {wanting.map((item) => (
            <li key={item.id} data-quality={item.quality}>
              <QualityMark quality={item.quality} size="1.5rem" />
              <div>
                <h2>{item.title}</h2>
                <p className={styles.what}>{item.what}</p>
                <p className={styles.why}>{item.why}</p>
                <p className={styles.remedy}>{item.remedy}</p>
              </div>
            </li>
          ))}
        </ul>
      )}
      <ul className={styles.fine}>
        {fine.map((item) => (
          <Fine key={item.id} item={item} />
        ))}
      </ul>
    </section>
  );
}

function titleOf(wanting: HealthItem[]): string {
  const bad = wanting.filter((item) => item.quality === "bad").length;
  if (bad > 0) return t("ui-problems", { n: bad });
  if (wanting.length > 0) return t("ui-items-need-attention", { n: wanting.length });
  return t("ui-everything-is-in-order");
}

function Fine({ item }: { item: HealthItem }) {
  return (
    <li>
      <details>
        <summary data-more={t("ui-why")} data-less={t("ui-less")}>
          <QualityMark quality={item.quality} size="1.25rem" />
          <span className={styles.name}>{item.title}</span>
          <span className={styles.short}>{item.what}</span>
        </summary>
        <p>{item.why}</p>
        {item.remedy && <p>{item.remedy}</p>}
      </details>
    </li>
  );
}
