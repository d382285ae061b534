import type { Step } from "../api/wire";
import { CheckIcon, StaleIcon } from "../controls/icons";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";
import type { SessionView } from "../state/store";
import styles from "./StepList.module.css";

const WORDS: Record<Step["state"], PlainId> = {
  done: "ui-done",
  current: "ui-now",
  todo: "ui-to-do",
  stale: "ui-to-do-again",
};

/** The steps of a guided session: what is done, where we are, what comes, what must be done again. */
export function StepList({ session }: { session: SessionView | null }) {
  if (!session?.running) return null;
  return (
    <ol className={styles.steps} aria-label={t("ui-steps")}>
      {session.steps.map((step, i) => (
        <li
          key={step.id}
          className={styles.step}
          data-state={step.state}
          aria-current={step.id === session.step ? "step" : undefined}
          title={step.title}
        >
          <span className={styles.mark}>
            <StepMark step={step} number={i + 1} />
          </span>
          <span className={styles.title}>{step.title}</span>
          <span className="visually-hidden">{t(WORDS[step.state])}</span>
        </li>
      ))}
    </ol>
  );
}

function StepMark({ step, number }: { step: Step; number: number }) {
  if (step.state === "done") return <CheckIcon size="1rem" />;
  if (step.state === "stale") return <StaleIcon size="1rem" />;
  return <>{number}</>;
}
