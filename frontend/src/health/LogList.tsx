import { useState } from "react";

import { useReread } from "../access/useReread";
import type { LogLine } from "../api/wire";
import rows from "../controls/List.module.css";
import { PressButton } from "../controls/PressButton";
import { QualityMark } from "../controls/QualityMark";
import { TextField } from "../controls/TextField";
import { useSettled } from "../controls/useSettled";
import { withIsolated } from "../state/isolated";
import { t, useLanguage } from "../state/language";
import styles from "./Health.module.css";

const LEVELS = [
  { level: "info", label: "ui-all" },
  { level: "warning", label: "ui-warnings" },
  { level: "error", label: "ui-errors" },
] as const;
const QUALITY = { info: "neutral", warning: "attention", error: "bad" } as const;

/** The station's log, the newest line first. */
export function LogList() {
  const [level, setLevel] = useState<LogLine["level"]>("info");
  const [words, setWords] = useState("");
  const settled = useSettled(words);
  const language = useLanguage();
  const query = `level=${level}&words=${encodeURIComponent(settled)}&lang=${language}`;
  const { list: lines, reread } = useReread<LogLine>(`/api/logs?${query}`);
  return (
    <section className={styles.section} aria-label={t("ui-log")}>
      <h2 className={rows.heading}>{t("ui-log")}</h2>
      <div className={styles.filter}>
        <div className={styles.levels} role="group" aria-label={t("ui-log-level")}>
          {LEVELS.map((one) => (
            <button
              key={one.level}
              type="button"
              aria-pressed={one.level === level}
              onClick={() => setLevel(one.level)}
            >
              {t(one.label)}
            </button>
          ))}
        </div>
        <TextField label={t("ui-search-text")} value={words} maxLength={100} onText={setWords} />
        <PressButton free kind="quiet" onPress={reread}>
          {t("ui-reload")}
        </PressButton>
      </div>
      <ol className={styles.log} aria-label={t("ui-log-lines")}>
        {lines?.map((line, i) => (
          <li key={`${line.at}${i}`} data-level={line.level}>
            <time>{timeOf(line.at)}</time>
            <QualityMark quality={QUALITY[line.level]} size="1.125rem" />
            <div>
              <p className={styles.text}>{withIsolated(line.text)}</p>
              <p className={styles.from}>{line.logger}</p>
              {line.trace && (
                <details>
                  <summary>{t("ui-source-in-the-program")}</summary>
                  <pre>{line.trace}</pre>
                </details>
              )}
            </div>
          </li>
        ))}
        {lines?.length === 0 && <li className={styles.empty}>{t("ui-no-log-line-matches")}</li>}
      </ol>
    </section>
  );
}

/** To the second, in the user's time zone. */
function timeOf(iso: string): string {
  const date = new Date(iso);
  if (Number.isNaN(date.getTime())) return iso;
  const two = (part: number) => String(part).padStart(2, "0");
  return `${two(date.getMonth() + 1)}-${two(date.getDate())} ${two(date.getHours())}:${two(date.getMinutes())}:${two(date.getSeconds())}`;
}
