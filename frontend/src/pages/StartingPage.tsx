import { useEffect, useState } from "react";
import { get } from "../api/http";
import type { Readiness } from "../api/wire";
import { CardHead } from "../controls/CardHead";
import { CheckIcon, Mark } from "../controls/icons";
import { Busy } from "../controls/Progress";
import { QualityMark } from "../controls/QualityMark";
import layout from "../frame/Layout.module.css";
import bar from "../frame/TopBar.module.css";
import { Illustration } from "../object/Illustration";
import { t } from "../state/language";
import styles from "./StartingPage.module.css";

const AGAIN_MS = 250;
/** After this many requests without an answer, the station counts as ended. */
const UNANSWERED = 8;
const WORDS = { done: "ui-done", current: "ui-now", todo: "ui-to-do" } as const;

/** The page shown during the start: current step and progress. */
export function StartingPage() {
  const { readiness, ended } = useReadiness();
  const steps = readiness?.steps ?? [];
  const done = readiness?.done ?? 0;
  const title = ended ? t("ui-the-station-did-not-start") : t("ui-starting-the-station");
  const text = ended
    ? t("ui-console-runs-crenel-states-reason-remedy")
    : t("ui-page-continues-automatically-once-everything-ready");
  useEffect(() => {
    document.title = `${title} · Crenel`;
  }, [title]);
  return (
    <div className={styles.frame}>
      <header className={bar.bar}>
        <div className={styles.brand}>
          <Mark />
          <div className={styles.names}>
            <span className={bar.name}>Crenel</span>
            <span className={bar.station}>{readiness?.station}</span>
          </div>
        </div>
      </header>
      <main className={layout.main}>
        <section className={layout.card} aria-label={t("ui-preparation")} tabIndex={0}>
          {ended ? (
            <div className={styles.ended} role="alert">
              <QualityMark quality="attention" />
              <CardHead title={title} text={text} />
            </div>
          ) : (
            <CardHead title={title} text={text} />
          )}
          {!ended && readiness && <Busy text={steps[done] ?? ""} fraction={readiness.share} />}
          <ol className={styles.steps} aria-label={t("ui-steps")} data-ended={ended || undefined}>
            {steps.map((step, i) => (
              <Step key={step} title={step} state={i < done ? "done" : i === done ? "current" : "todo"} />
            ))}
          </ol>
        </section>
        <section className={layout.picture} aria-label={t("ui-picture")}>
          <Illustration />
        </section>
      </main>
    </div>
  );
}

function Step({ title, state }: { title: string; state: keyof typeof WORDS }) {
  return (
    <li className={styles.step} data-state={state} aria-current={state === "current" ? "step" : undefined}>
      <span className={styles.mark}>{state === "done" && <CheckIcon size="1rem" />}</span>
      <span>{title}</span>
      <span className="visually-hidden">{t(WORDS[state])}</span>
    </li>
  );
}

/** Polls until the station is ready, then opens its client at the same address. */
function useReadiness(): { readiness: Readiness | null; ended: boolean } {
  const [readiness, setReadiness] = useState<Readiness | null>(null);
  const [unanswered, setUnanswered] = useState(0);
  useEffect(() => {
    let timer = 0;
    const ask = async () => {
      try {
        const answer = await get<Readiness>("/api/starting");
        if (answer.ready) return window.location.reload();
        setReadiness(answer);
        setUnanswered(0);
        if (answer.failed) return;
      } catch {
        setUnanswered((times) => times + 1);
      }
      timer = window.setTimeout(ask, AGAIN_MS);
    };
    void ask();
    return () => window.clearTimeout(timer);
  }, []);
  return { readiness, ended: readiness?.failed || unanswered >= UNANSWERED };
}
