import { useRef, useState } from "react";

import { playRecord } from "../api/recordCommands";
import type { OpenedRecord } from "../api/wire";
import { Chips } from "../controls/Chips";
import { duration } from "../controls/format";
import { PressButton } from "../controls/PressButton";
import { quantity } from "../messages/text";
import { t } from "../state/language";
import styles from "./ReplayBar.module.css";

const SPEEDS = [1, 4, 16];
/** While the handle is drawn, the view follows this often. */
const FOLLOW_MS = 250;

/** Plays the opened record as it was scanned: its time, and how fast. */
export function ReplayBar({ record: { replay, seconds } }: { record: OpenedRecord }) {
  const [speed, setSpeed] = useState(replay?.speed ?? 4);
  const [drawn_s, setDrawn] = useState<number | null>(null);
  const followed = useRef(0);
  const playing = replay?.playing ?? false;
  const at_s = drawn_s ?? replay?.at_s ?? seconds;
  const draw = (to_s: number, ended: boolean) => {
    setDrawn(ended ? null : to_s);
    const now = performance.now();
    if (!ended && now - followed.current < FOLLOW_MS) return;
    followed.current = now;
    void playRecord({ at_s: to_s, playing: ended && playing, speed });
  };
  const choose = (faster: number) => {
    setSpeed(faster);
    if (playing) void playRecord({ at_s: null, playing: true, speed: faster });
  };
  return (
    <div className={styles.bar} role="group" aria-label={t("ui-replay")}>
      <input
        className={styles.time}
        type="range"
        min={0}
        max={seconds}
        step={Math.max(seconds / 1000, 0.01)}
        value={at_s}
        aria-label={t("ui-time-of-the-scan")}
        aria-valuetext={t("ui-done-of-all", { done: duration(at_s), all: duration(seconds) })}
        onChange={(event) => draw(Number(event.target.value), false)}
        onPointerUp={(event) => draw(Number(event.currentTarget.value), true)}
        onKeyUp={(event) => draw(Number(event.currentTarget.value), true)}
      />
      <div className={styles.line}>
        <PressButton
          onPress={async () => {
            await playRecord({ at_s: replay ? null : 0, playing: !playing, speed });
          }}
        >
          {playing ? t("ui-pause") : t("ui-play")}
        </PressButton>
        <Chips
          label={t("ui-speed")}
          value={speed}
          onChange={choose}
          options={SPEEDS.map((one) => ({ value: one, label: t("ui-times-speed", { n: quantity(one) }) }))}
        />
        <span className={styles.words}>{t("ui-done-of-all", { done: duration(at_s), all: duration(seconds) })}</span>
      </div>
    </div>
  );
}
