import { useSyncExternalStore } from "react";

/** Notes of each sound: frequency in Hz, start and length in seconds. */
const TUNES: Record<string, [number, number, number][]> = {
  point_taken: [[1175, 0, 0.07]],
  refused: [
    [233, 0, 0.12],
    [196, 0.15, 0.2],
  ],
  step_done: [
    [784, 0, 0.09],
    [1047, 0.1, 0.16],
  ],
};

const KEY = "crenel-muted";
const listeners = new Set<() => void>();
let muted = window.localStorage.getItem(KEY) === "1";
let context: AudioContext | null = null;

/** Browsers allow sound only after the first user action. */
export function unlockSound(): void {
  const unlock = () => {
    context ??= new AudioContext();
    void context.resume();
  };
  window.addEventListener("pointerdown", unlock, { once: true });
  window.addEventListener("keydown", unlock, { once: true });
}

export function playFor(kind: string): void {
  const tune = TUNES[kind];
  if (!tune || muted || !context) return;
  for (const [frequency_hz, start_s, length_s] of tune) {
    const begin = context.currentTime + start_s;
    const tone = context.createOscillator();
    const level = context.createGain();
    tone.frequency.value = frequency_hz;
    level.gain.setValueAtTime(0, begin);
    level.gain.linearRampToValueAtTime(0.18, begin + 0.008);
    level.gain.exponentialRampToValueAtTime(0.001, begin + length_s);
    tone.connect(level).connect(context.destination);
    tone.start(begin);
    tone.stop(begin + length_s);
  }
}

export function toggleMuted(): void {
  muted = !muted;
  window.localStorage.setItem(KEY, muted ? "1" : "0");
  for (const listener of listeners) listener();
}

export function useMuted(): boolean {
  return useSyncExternalStore(
    (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    () => muted,
  );
}
