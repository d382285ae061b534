import type { FlowView } from "../api/flowTypes";
import type { Step } from "../api/types";
import { CheckIcon, StaleIcon } from "../parts/icons";
import { t, words } from "../state/language";
import styles from "./StepList.module.css";

const WORDS: Record<Step["state"], string> = {
  done: words("done"),
  current: words("now"),
  todo: words("to do"),
  stale: words("to be done again"),
};

/** The steps of the flow: what is done, where we are, what comes, what must be done again. */
export function StepList({ flow }: { flow: Pick<FlowView, "running" | "steps" | "step"> | null }) {
  if (!flow?.running) return null;
  return (
    <ol className={styles.steps} aria-label={t("Steps")}>
      {flow.steps.map((step, i) => (
        <li
          key={step.id}
          className={styles.step}
          data-state={step.state}
          aria-current={step.id === flow.step ? "step" : undefined}
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
  if (step.state === words("done")) return <CheckIcon size="1rem" />;
  if (step.state === "stale") return <StaleIcon size="1rem" />;
  return <>{number}</>;
}
