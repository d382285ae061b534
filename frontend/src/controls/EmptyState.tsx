import type { ReactNode } from "react";

import { Illustration } from "../object/Illustration";
import styles from "./EmptyState.module.css";

/** A page without data: what will appear here and how to get it. */
export function EmptyState({ title, text, picture }: { title: string; text: string; picture?: ReactNode }) {
  return (
    <div className={styles.empty}>
      {picture ?? <Illustration />}
      <div className={styles.words}>
        <h2 className={styles.title}>{title}</h2>
        <p className={styles.text}>{text}</p>
      </div>
    </div>
  );
}
