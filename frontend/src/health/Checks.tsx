import type { Health, HealthItem } from "../api/watchTypes";
import { bound } from "../parts/format";
import { QualityMark } from "../parts/QualityMark";
import { t } from "../state/language";
import styles from "./Health.module.css";

/** Every check: what needs somebody in full, the rest in a line each. */
export function Checks({ health }: { health: Health }) {
  const wanting = health.items.filter((item) => item.quality === "bad" || item.quality === "attention");
  const fine = health.items.filter((item) => item.quality === "good" || item.quality === "neutral");
  return (
    <section className={styles.section} aria-label={t("Health")}>
      <h1 className={styles.title}>{titleOf(wanting)}</h1>
      {wanting.length > 0 && (
        <ul className={styles.wanting}>
          {wanting.map((item) => (
            <li key={item.id} data-quality={item.quality}>
              <QualityMark quality={item.quality} size="1.5rem" />
              <div>
                <h2>{item.title}</h2>
                <p className={styles.what}>{bound(item.what)}</p>
                <p className={styles.why}>{bound(item.why)}</p>
                <p className={styles.remedy}>{bound(item.remedy)}</p>
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
  if (bad > 0) return bad === 1 ? t("One thing is wrong") : t("{n} things are wrong", { n: bad });
  if (wanting.length > 0) return wanting.length === 1 ? t("One thing wants attention") : t("{n} things want attention", { n: wanting.length });
  return t("All is well");
}

function Fine({ item }: { item: HealthItem }) {
  return (
    <li>
      <details>
        <summary data-more={t("Why")} data-less={t("Less")}>
          <QualityMark quality={item.quality} size="1.25rem" />
          <span className={styles.name}>{item.title}</span>
          <span className={styles.short}>{bound(item.what)}</span>
        </summary>
        <p>{bound(item.why)}</p>
        {item.remedy && <p>{bound(item.remedy)}</p>}
      </details>
    </li>
  );
}
