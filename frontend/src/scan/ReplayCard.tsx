import type { ReplayState } from "../api/types";
import { BigNumber } from "../parts/BigNumber";
import { CardHead } from "../parts/CardHead";
import { Findings } from "../parts/Findings";
import { duration, figures } from "../parts/format";
import { Progress } from "../parts/Progress";

const TITLES: Record<ReplayState["state"], string> = {
  playing: "A recording is replayed",
  ended: "The replay has ended",
  failed: "The replay stopped",
};

/** In place of the scan's card while the station shows a recording again. */
export function ReplayCard({ replay }: { replay: ReplayState }) {
  const { state, recording, text } = replay;
  return (
    <>
      <CardHead title={TITLES[state]} text={`${recording}, ${pace(replay.speed)}. ${next(state)}`} />
      <BigNumber
        number={{ label: "Points", value: replay.points, unit: "", decimals: 0, quality: "neutral", note: shown(replay) }}
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
  if (length_s === null) return <p>{duration(played_s)} played</p>;
  // the frames of the last moment may lie before the arm's last reading
  const done_s = state === "ended" ? length_s : Math.min(played_s, length_s);
  const share = length_s > 0 ? done_s / length_s : 1;
  return <Progress done={Math.round(1000 * share)} of={1000} text={`${duration(done_s)} of ${duration(length_s)}`} />;
}

function pace(speed: number): string {
  if (speed === 0) return "as fast as it can be read";
  return speed === 1 ? "at the speed it was taken at" : `at ${figures(speed, speed < 10 && speed % 1 ? 1 : 0)} times its speed`;
}

function next(state: ReplayState["state"]): string {
  if (state === "playing") return "At its end the whole cloud stays here.";
  if (state === "ended") return "The whole cloud stays here; to see it again, start crenel replay anew.";
  return "What was shown stays here.";
}

function shown({ points, points_shown }: ReplayState): string {
  return points_shown < points ? "the view shows a part of them" : "";
}
