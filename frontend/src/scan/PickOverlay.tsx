import { type PointerEvent, useEffect, useRef, useState } from "react";
import type { Region } from "../api/types";
import look from "../controls/Control.module.css";
import { t } from "../state/language";
import styles from "./PickOverlay.module.css";

interface PickOverlayProps {
  /** What is to be drawn. */
  words: string;
  onPick: (region: Region) => void;
  onCancel: () => void;
}

type Spot = { x: number; y: number };

/** A drag shorter than this share of the picture is ignored. */
const SMALLEST = 0.01;

/** Overlay on the 3D view: the user draws a rectangle around points. */
export function PickOverlay({ words, onPick, onCancel }: PickOverlayProps) {
  const area = useRef<HTMLDivElement>(null);
  const [from, setFrom] = useState<Spot | null>(null);
  const [to, setTo] = useState<Spot | null>(null);

  useEffect(() => {
    const leave = (event: KeyboardEvent) => event.key === "Escape" && onCancel();
    window.addEventListener("keydown", leave);
    return () => window.removeEventListener("keydown", leave);
  }, [onCancel]);

  const spot = (event: PointerEvent): Spot => {
    const box = area.current?.getBoundingClientRect() ?? new DOMRect(0, 0, 1, 1);
    const share = (at: number, start: number, length: number) => Math.min(Math.max((at - start) / length, 0), 1);
    return { x: share(event.clientX, box.left, box.width), y: share(event.clientY, box.top, box.height) };
  };
  const start = (event: PointerEvent) => {
    event.currentTarget.setPointerCapture(event.pointerId);
    setFrom(spot(event));
    setTo(spot(event));
  };
  const region = from && to ? regionOf(from, to) : null;
  const end = () => {
    setFrom(null);
    if (region && region.right - region.left > SMALLEST && region.bottom - region.top > SMALLEST) onPick(region);
  };
  return (
    <div
      ref={area}
      className={styles.area}
      onPointerDown={start}
      onPointerMove={(event) => from && setTo(spot(event))}
      onPointerUp={end}
      onPointerCancel={() => setFrom(null)}
    >
      {region && <div className={styles.rectangle} style={boxOf(region)} />}
      <div className={styles.words}>
        <p>{words}</p>
        <button
          type="button"
          className={`${look.button} ${styles.cancel}`}
          autoFocus
          onPointerDown={(event) => event.stopPropagation()}
          onClick={onCancel}
        >
          {t("ui-cancel")}
        </button>
      </div>
    </div>
  );
}

function regionOf(a: Spot, b: Spot): Region {
  return {
    left: Math.min(a.x, b.x),
    top: Math.min(a.y, b.y),
    right: Math.max(a.x, b.x),
    bottom: Math.max(a.y, b.y),
  };
}

function boxOf({ left, top, right, bottom }: Region) {
  const percent = (share: number) => `${100 * share}%`;
  return { left: percent(left), top: percent(top), width: percent(right - left), height: percent(bottom - top) };
}
