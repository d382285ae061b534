import type { ReactNode } from "react";

import { t } from "../state/language";
import { Banners } from "./Banners";
import styles from "./Layout.module.css";

/**
 * The picture displays where, the card what: two thirds and one third.
 * The card comes first for the keyboard, so that its acts are not behind every dot.
 */
export function Layout({ picture, card }: { picture: ReactNode; card: ReactNode }) {
  return (
    <main className={styles.main}>
      <section className={styles.card} data-part="card" aria-label={t("ui-current-step")} tabIndex={0}>
        {card}
      </section>
      <section className={styles.picture} data-part="picture" aria-label={t("ui-picture")} tabIndex={0}>
        {picture}
      </section>
      <Banners />
    </main>
  );
}
