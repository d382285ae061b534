import { type Ref, useId, useState } from "react";
import type { PlainId } from "../messages/text";

import { t } from "../state/language";
import styles from "./CardHead.module.css";
import { HELP } from "./help";

interface CardHeadProps {
  title: string;
  text: string;
  /** Which lines of `HELP` belong to it, if any. */
  help?: string;
  ref?: Ref<HTMLHeadingElement>;
}

/** The title of the card and its sentence, with more help on request. */
export function CardHead({ title, text, help, ref }: CardHeadProps) {
  return (
    <div className={styles.head}>
      <h1 className={styles.title} tabIndex={-1} ref={ref}>
        {title}
      </h1>
      <p className={styles.text}>{text}</p>
      {/* another step begins with its help closed */}
      {help && HELP[help] && <Help key={help} lines={HELP[help]} />}
    </div>
  );
}

function Help({ lines }: { lines: readonly PlainId[] }) {
  const [open, setOpen] = useState(false);
  const id = useId();
  return (
    <>
      <button
        type="button"
        className={styles.ask}
        aria-expanded={open}
        aria-controls={id}
        onClick={() => setOpen(!open)}
      >
        {t("ui-help")}
      </button>
      <ul id={id} className={styles.help} data-help hidden={!open}>
        {lines.map((line) => (
          <li key={line}>{t(line)}</li>
        ))}
      </ul>
    </>
  );
}
