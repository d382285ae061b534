import { useState } from "react";

import type { DimensionLine, PartResultView, PartView } from "../api/wire";
import { newFindings } from "../controls/findings";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import { SessionCard } from "../flow/SessionCard";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { DeviationBar } from "./DeviationBar";
import { limitsOf, spreadText } from "./DimensionTable";
import { OUTCOME_QUALITY, OUTCOMES, shown } from "./outcomes";
import styles from "./PartCard.module.css";
import { SkipForm } from "./SetupForm";

/** What to do now: the feature in hand with its figures, the frame, the acts. */
export function PartCard({ view }: { view: PartView }) {
  const [skipping, setSkipping] = useState("");
  const canSkip = view.step === "measure" && view.busy === null;
  const asks = canSkip && skipping === view.feature;
  return (
    <SessionCard
      guide="parts"
      view={view}
      actions={asks ? [] : view.actions}
      number={<Figures view={view} />}
      findings={newFindings(view.findings, view.actions, [])}
      verdict={view.step === "review"}
    >
      {view.frame && <p className={styles.frame}>{view.frame}</p>}
      {asks && <SkipForm feature={view.feature} onDone={() => setSkipping("")} />}
      {canSkip && (
        <PressButton free kind="quiet" onPress={() => setSkipping(asks ? "" : view.feature)}>
          {asks ? t("ui-part-do-not-skip") : t("ui-part-skip")}
        </PressButton>
      )}
    </SessionCard>
  );
}

/** The dimensions of the feature in hand, large; or the verdict. */
function Figures({ view }: { view: PartView }) {
  if (view.result) return <VerdictLine result={view.result} />;
  if (view.dimensions.length === 0) return null;
  return (
    <ul className={styles.figures} aria-live="polite">
      {view.dimensions.map((line) => (
        <Figure key={line.id} line={line} />
      ))}
    </ul>
  );
}

/** The word for all dimensions together. */
export function VerdictLine({ result: { verdict, text } }: { result: PartResultView }) {
  return (
    <div className={styles.verdict} data-verdict={verdict}>
      <QualityMark quality={OUTCOME_QUALITY[verdict]} size="2rem" />
      <p>{text}</p>
    </div>
  );
}

function Figure({ line }: { line: DimensionLine }) {
  return (
    <li className={styles.figure} data-dimension={line.id}>
      <p className={styles.name}>
        <span>
          {isolated(line.id)} <span className={styles.kind}>{line.title}</span>
        </span>
        <span className={styles.word} data-decision={line.decision}>
          <QualityMark quality={OUTCOME_QUALITY[line.decision]} size="1.25rem" />
          {t(OUTCOMES[line.decision])}
        </span>
      </p>
      <div className={styles.measured}>
        <p className={styles.value}>{shown(line.value, line)}</p>
        <DeviationBar line={line} />
      </div>
      <p className={styles.detail}>
        {[`${shown(line.nominal, line)} ${limitsOf(line)}`, spreadText(line)].filter(Boolean).join(" · ")}
      </p>
    </li>
  );
}
