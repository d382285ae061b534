import { type KeyboardEvent, useRef } from "react";

import type { ChoiceOption } from "../api/wire";
import { CheckIcon } from "../controls/icons";
import { isolated } from "../state/isolated";
import styles from "./ChoicesPicture.module.css";

interface ChoiceGroupProps {
  title: string;
  options: (ChoiceOption & { why_not?: string })[];
  selected: string;
  onChoose: (id: string) => void;
}

/**
 * One of several, each with what distinguishes it, or why it cannot be chosen; the arrow keys go from
 * one to the next.
 */
export function ChoiceGroup({ title, options, selected, onChoose }: ChoiceGroupProps) {
  const group = useRef<HTMLDivElement>(null);
  const onKey = (event: KeyboardEvent) => {
    const step = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const buttons = Array.from(group.current?.querySelectorAll("button") ?? []);
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    buttons[(at + step + buttons.length) % buttons.length]?.focus();
  };
  return (
    <section>
      <h3 className={styles.heading}>{title}</h3>
      <div ref={group} role="radiogroup" aria-label={title} onKeyDown={onKey} className={styles.options}>
        {options.map((option) => (
          <button
            key={option.id}
            type="button"
            role="radio"
            aria-checked={option.id === selected}
            aria-disabled={option.why_not ? true : undefined}
            className={styles.option}
            onClick={() => option.id === selected || option.why_not || onChoose(option.id)}
          >
            <span className={styles.tick}>{option.id === selected && <CheckIcon size="1.125rem" />}</span>
            <span>
              <span className={styles.label}>{isolated(option.label)}</span>
              <span className={styles.detail}>{option.detail}</span>
              {option.why_not && <span className={styles.why}>{option.why_not}</span>}
            </span>
          </button>
        ))}
      </div>
    </section>
  );
}
