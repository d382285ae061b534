import type { ReactNode } from "react";

import { t } from "../state/language";
import { Banners } from "./Banners";
import styles from "./Layout.module.css";

/**
 * The picture says where, the card says what: two thirds and one third.
 * The card comes first for the keyboard, so that its acts are not behind every dot.
 */
export function Layout({ picture, card }: { picture: ReactNode; card: ReactNode }) {
  return (
    <main className={styles.main}>
      <section className={styles.card} aria-label={t("What to do")}>
        {card}
      </section>
      <section className={styles.picture} aria-label={t("Picture")}>
        {picture}
      </section>
      <Banners />
    </main>
  );
}
