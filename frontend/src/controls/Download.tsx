import type { ReactNode } from "react";
import { addressOf } from "../state/base";

import look from "./Control.module.css";
import styles from "./Download.module.css";
import { DownloadIcon } from "./icons";

/** A button that saves a file of the station; `href` is its path there. */
export function Download({ href, children }: { href: string; children: ReactNode }) {
  return (
    <a className={`${look.button} ${styles.download}`} href={addressOf(href)} download>
      <DownloadIcon size="1.25rem" />
      {children}
    </a>
  );
}
