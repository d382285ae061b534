import type { ReactNode } from "react";

import styles from "./Layout.module.css";

/** The picture says where, the card says what: two thirds and one third. */
export function Layout({ picture, card }: { picture: ReactNode; card: ReactNode }) {
  return (
    <main className={styles.main}>
      <section className={styles.picture} aria-label="Picture">
        {picture}
      </section>
      <section className={styles.card} aria-label="What to do">
        {card}
      </section>
    </main>
  );
}
