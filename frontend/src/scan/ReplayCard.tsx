import type { ReplayState } from "../api/scanTypes";
import { BigNumber } from "../parts/BigNumber";
import { CardHead } from "../parts/CardHead";
import { Findings } from "../parts/Findings";
import { duration, figures } from "../parts/format";
import { Progress } from "../parts/Progress";
import { t, words } from "../state/language";

const TITLES: Record<ReplayState["state"], string> = {
  playing: words("A recording is replayed"),
  ended: words("The replay has ended"),
  failed: words("The replay stopped"),
};

/** In place of the scan's card while the station shows a recording again. */
export function ReplayCard({ replay }: { replay: ReplayState }) {
  const { state, recording, text } = replay;
  return (
    <>
      <CardHead title={t(TITLES[state])} text={`${recording}, ${pace(replay.speed)}. ${next(state)}`} />
      <BigNumber
        number={{ label: t("Points"), value: replay.points, unit: "", decimals: 0, quality: "neutral", note: shown(replay) }}
      />
      <Bar replay={replay} />
      {text && (
        <Findings
          findings={[{ quality: state === "failed" ? "bad" : "attention", text, remedy: "", pose: null }]}
        />
      )}
    </>
  );
}

function Bar({ replay: { played_s, length_s, state } }: { replay: ReplayState }) {
  if (length_s === null) return <p>{t("{time} played", { time: duration(played_s) })}</p>;
  // the frames of the last moment may lie before the arm's last reading
  const done_s = state === "ended" ? length_s : Math.min(played_s, length_s);
  const share = length_s > 0 ? done_s / length_s : 1;
  return <Progress done={Math.round(1000 * share)} of={1000} text={t("{done} of {all}", { done: duration(done_s), all: duration(length_s) })} />;
}

function pace(speed: number): string {
  if (speed === 0) return t("as fast as it can be read");
  return speed === 1 ? t("at the speed it was taken at") : t("at {n} times its speed", { n: figures(speed, speed < 10 && speed % 1 ? 1 : 0) });
}

function next(state: ReplayState["state"]): string {
  if (state === "playing") return t("At its end the whole cloud stays here.");
  if (state === "ended") return t("The whole cloud stays here; to see it again, start crenel replay anew.");
  return t("What was shown stays here.");
}

function shown({ points, points_shown }: ReplayState): string {
  return points_shown < points ? t("the view shows a part of them") : "";
}
