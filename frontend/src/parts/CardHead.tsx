import type { Ref } from "react";

import { bound } from "./format";
import styles from "./CardHead.module.css";

interface CardHeadProps {
  title: string;
  text: string;
  ref?: Ref<HTMLHeadingElement>;
}

/** The card's title and its one sentence. */
export function CardHead({ title, text, ref }: CardHeadProps) {
  return (
    <div className={styles.head}>
      <h1 className={styles.title} tabIndex={-1} ref={ref}>
        {title}
      </h1>
      <p className={styles.text}>{bound(text)}</p>
    </div>
  );
}
