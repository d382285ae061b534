import { useEffect, useState } from "react";

import { watchStations } from "../api/stations";
import type { Quality } from "../api/types";
import type { RemoteStation, StationReport } from "../api/wire";
import { age } from "../controls/format";
import { Mark } from "../controls/icons";
import { QualityMark } from "../controls/QualityMark";
import { useSilence } from "../state/freshness";
import { isolated } from "../state/isolated";
import { t } from "../state/language";
import { useLive } from "../state/store";
import { Board } from "../supervise/Board";
import { StationCards } from "../supervise/StationCards";
import { stationState, worst } from "../supervise/stationFacts";
import styles from "./SupervisePage.module.css";

const KEY = "crenel-supervise";
type Scope = "this" | "all";

/** For supervision: this station in large type, or all stations on the broker. */
export function SupervisePage() {
  const report = useLive((s) => s.report);
  const others = useLive((s) => s.stations);
  const at = useLive((s) => s.stationsAt);
  useEffect(watchStations, []);
  const kiosk = useLive((s) => s.session?.you?.kiosk ?? false);
  const { live, silent_s } = useSilence();
  const [chosen, choose] = useState<Scope>(() => (localStorage.getItem(KEY) === "all" ? "all" : "this"));
  const several = (others?.length ?? 0) > 0;
  const scope = several ? chosen : "this";
  const pick = (one: Scope) => {
    localStorage.setItem(KEY, one);
    choose(one);
  };
  if (!report) {
    return (
      <main className={styles.page}>
        <p className={styles.waiting}>{t("ui-waiting-for-the-station")}</p>
      </main>
    );
  }
  return (
    <main className={styles.page} data-kiosk={kiosk || undefined}>
      <header className={styles.head}>
        {kiosk && <Mark size="1.5em" />}
        <h1 className={styles.name}>{scope === "all" ? t("ui-all-stations") : isolated(report.name)}</h1>
        <Freshness
          live={live}
          silent_s={silent_s}
          {...(scope === "all" ? sumOf(report, others ?? []) : alarmsOf(report))}
        />
        {several && (
          <div className={styles.choice} role="group" aria-label={t("ui-view")}>
            <button type="button" aria-pressed={scope === "this"} onClick={() => pick("this")}>
              {t("ui-this-station")}
            </button>
            <button type="button" aria-pressed={scope === "all"} onClick={() => pick("all")}>
              {t("ui-all-n", { n: (others?.length ?? 0) + 1 })}
            </button>
          </div>
        )}
        <TimeOfDay />
      </header>
      {scope === "all" && others ? (
        <StationCards stations={[own(report, live, silent_s), ...others]} at={at} kiosk={kiosk} />
      ) : (
        <Board report={report} silent_s={live ? 0 : silent_s} />
      )}
    </main>
  );
}

function own(report: StationReport, live: boolean, silent_s: number): RemoteStation {
  return {
    id: report.station,
    name: report.name,
    state: live ? "live" : "lost",
    silent_s,
    report,
    alarms: report.alarms.length,
    events: [],
  };
}

interface Sum {
  words: string;
  quality: Quality;
}

function alarmsOf(report: StationReport): Sum {
  const alarms = report.alarms.length;
  return { words: alarms ? t("ui-n-alarms", { n: alarms }) : t("ui-live"), quality: worst(report) };
}

/** The number of stations that need attention, of all stations. */
function sumOf(report: StationReport, others: RemoteStation[]): Sum {
  const qualities = [worst(report), ...others.map((one) => stationState(one).quality)];
  const count = (quality: Quality) => qualities.filter((one) => one === quality).length;
  if (count("bad"))
    return { words: t("ui-of-with-faults", { n: count("bad"), all: qualities.length }), quality: "bad" };
  if (count("attention"))
    return { words: t("ui-of-need-attention", { n: count("attention"), all: qualities.length }), quality: "attention" };
  return { words: t("ui-n-stations", { n: qualities.length }), quality: "good" };
}

function Freshness({ live, silent_s, words, quality }: Sum & { live: boolean; silent_s: number }) {
  if (!live) {
    return (
      <p className={styles.fresh} data-quality="bad" role="status">
        <QualityMark quality="bad" size="1em" /> {t("ui-no-contact-for", { age: age(Math.floor(silent_s)) })}
      </p>
    );
  }
  return (
    <p className={styles.fresh} data-quality={quality}>
      <QualityMark quality={quality} size="1em" /> {words}
    </p>
  );
}

/** It moves, to show that the screen itself works. */
function TimeOfDay() {
  const [now, setNow] = useState(() => new Date());
  useEffect(() => {
    const timer = setInterval(() => setNow(new Date()), 1000);
    return () => clearInterval(timer);
  }, []);
  const two = (part: number) => String(part).padStart(2, "0");
  return (
    <time className={styles.time}>
      {two(now.getHours())}:{two(now.getMinutes())}
      <span>:{two(now.getSeconds())}</span>
    </time>
  );
}
