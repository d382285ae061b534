import type { Quality } from "../api/types";
import { t } from "../state/language";
import { AttentionIcon, BadIcon, CheckIcon, NeutralIcon } from "./icons";
import styles from "./QualityMark.module.css";

const MARKS = { good: CheckIcon, attention: AttentionIcon, bad: BadIcon, neutral: NeutralIcon };
const TITLES = { good: "ui-passed", attention: "ui-attention", bad: "ui-failed", neutral: null } as const;

/** A quality as shape, word and colour: never as colour alone. */
export function QualityMark({ quality, size = "1.5rem" }: { quality: Quality; size?: string }) {
  const Icon = MARKS[quality];
  const title = TITLES[quality];
  return (
    <span className={styles.mark} data-quality={quality}>
      <Icon size={size} />
      <span className="visually-hidden">{title && t(title)}</span>
    </span>
  );
}
