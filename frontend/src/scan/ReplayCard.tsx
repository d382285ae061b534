import type { ReplayState } from "../api/wire";
import { BigNumber } from "../controls/BigNumber";
import { CardHead } from "../controls/CardHead";
import { Findings } from "../controls/Findings";
import { duration } from "../controls/format";
import { Progress } from "../controls/Progress";
import { type PlainId, quantity } from "../messages/text";
import { t } from "../state/language";

const TITLES: Record<ReplayState["state"], PlainId> = {
  playing: "ui-replaying-a-recording",
  ended: "ui-the-replay-has-ended",
  failed: "ui-the-replay-stopped",
};

/** Replaces the scan card while the station replays a recording. */
export function ReplayCard({ replay }: { replay: ReplayState }) {
  const { state, recording, text } = replay;
  return (
    <>
      <CardHead title={t(TITLES[state])} text={`${recording}, ${pace(replay.speed)}. ${next(state)}`} />
      <BigNumber
        number={{
          label: t("ui-points"),
          value: replay.points,
          unit: "",
          decimals: 0,
          quality: "neutral",
          note: displayedShare(replay),
        }}
      />
      <Bar replay={replay} />
      {text && (
        <Findings findings={[{ quality: state === "failed" ? "bad" : "attention", text, remedy: "", pose: null }]} />
      )}
    </>
  );
}

function Bar({ replay: { played_s, length_s, state } }: { replay: ReplayState }) {
  if (length_s === null) return <p>{t("ui-played", { time: duration(played_s) })}</p>;
  // the frames of the last moment may lie before the arm's last reading
  const done_s = state === "ended" ? length_s : Math.min(played_s, length_s);
  const share = length_s > 0 ? done_s / length_s : 1;
  return (
    <Progress
      done={Math.round(1000 * share)}
      of={1000}
      text={t("ui-done-of-all", { done: duration(done_s), all: duration(length_s) })}
    />
  );
}

function pace(speed: number): string {
  if (speed === 0) return t("ui-as-fast-as-possible");
  return speed === 1
    ? t("ui-at-the-original-speed")
    : t("ui-at-times-the-original-speed", { n: quantity(speed, "", speed < 10 && speed % 1 ? 1 : 0) });
}

function next(state: ReplayState["state"]): string {
  if (state === "playing") return t("ui-complete-cloud-stays-end");
  if (state === "ended") return t("ui-complete-cloud-stays-replay-run-crenel");
  return t("ui-the-cloud-so-far-stays-here");
}

function displayedShare({ points, points_shown }: ReplayState): string {
  return points_shown < points ? t("ui-view-contains-only-some-them") : "";
}
