import type { ReactNode } from "react";

import look from "./Control.module.css";
import styles from "./Download.module.css";
import { DownloadIcon } from "./icons";

export function Download({ href, children }: { href: string; children: ReactNode }) {
  return (
    <a className={`${look.button} ${styles.download}`} href={href} download>
      <DownloadIcon size="1.25rem" />
      {children}
    </a>
  );
}
