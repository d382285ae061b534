import { type KeyboardEvent, type PointerEvent, useEffect, useRef, useState } from "react";

import type { Frame } from "../image/LiveCamera";
import { t } from "../state/language";
import type { Zone, Zones } from "./useZones";
import styles from "./ZoneEditor.module.css";

const HANDLE = 13;
const TARGET = 26;
const LEAST = 8;
const STEP = 5;

interface Pull {
  zones: Zone[];
  zone: number;
  corner: number;
  /** Start of a rectangle that is being drawn. */
  from: [number, number] | null;
}

/** The zones on the live picture, with corners that can be dragged with gloves. */
export function ZoneEditor({ frame, current, zones }: { frame: Frame; current: Zone[]; zones: Zones }) {
  const svg = useRef<SVGSVGElement>(null);
  const [pull, setPull] = useState<Pull | null>(null);
  const displayed = pull?.zones ?? current;
  // biome-ignore lint/correctness/useExhaustiveDependencies: the station's zones replace those that are pulled
  useEffect(() => setPull(null), [current]);
  const { width_px, height_px, scale } = frame;

  const at = (event: PointerEvent): [number, number] => {
    const box = svg.current?.getBoundingClientRect();
    if (!box) return [0, 0];
    const within = (value: number, most: number) => Math.round(Math.min(Math.max(value, 0), most) * 10) / 10;
    return [
      within((event.clientX - box.left) / scale - 0.5, width_px - 1),
      within((event.clientY - box.top) / scale - 0.5, height_px - 1),
    ];
  };
  const begin = (event: PointerEvent) => {
    if (!zones.drawing || event.button !== 0) return;
    svg.current?.setPointerCapture(event.pointerId);
    const from = at(event);
    setPull({ zones: [...current, rectangle(from, from)], zone: current.length, corner: -1, from });
  };
  const take = (zone: number, corner: number, event: PointerEvent, fresh = false) => {
    if (event.button !== 0) return;
    event.stopPropagation();
    svg.current?.setPointerCapture(event.pointerId);
    const pulled = fresh ? withCorner(current, zone, corner, at(event)) : current;
    setPull({ zones: pulled, zone, corner, from: null });
  };
  const move = (event: PointerEvent) => {
    if (!pull) return;
    const to = at(event);
    const moved = pull.from ? rectangle(pull.from, to) : replaced(pull.zones[pull.zone] ?? [], pull.corner, to);
    setPull({ ...pull, zones: replaced(pull.zones, pull.zone, moved) });
  };
  const end = () => {
    if (!pull) return;
    const zone = pull.zones[pull.zone] ?? [];
    if (pull.from && !isLarge(zone)) return setPull(null);
    void zones.set(pull.zones).then(() => setPull(null));
  };
  const key = (zone: number, corner: number, event: KeyboardEvent) => {
    const to = moved(current, zone, corner, event.key);
    if (!to) return;
    event.preventDefault();
    void zones.set(to);
  };
  return (
    <svg
      ref={svg}
      className={styles.editor}
      data-drawing={zones.drawing || undefined}
      viewBox={`-0.5 -0.5 ${width_px} ${height_px}`}
      role="group"
      aria-label={t("ui-zones-without-measurement")}
      onPointerDown={begin}
      onPointerMove={move}
      onPointerUp={end}
      onPointerCancel={() => setPull(null)}
    >
      <defs>
        <pattern
          id="hatch"
          width={12 / scale}
          height={12 / scale}
          patternUnits="userSpaceOnUse"
          patternTransform="rotate(45)"
        >
          <rect width={12 / scale} height={12 / scale} className={styles.ground} />
          <rect width={4 / scale} height={12 / scale} className={styles.line} />
        </pattern>
      </defs>
      {displayed.map((zone, i) => (
        <polygon
          key={i}
          points={zone.map((corner) => corner.join()).join(" ")}
          className={styles.zone}
          fill="url(#hatch)"
        />
      ))}
      {!zones.drawing &&
        displayed.map((zone, i) =>
          zone.map(([u, v], k) => {
            const [nextU, nextV] = zone[(k + 1) % zone.length] ?? [u, v];
            const [midU, midV] = [(u + nextU) / 2, (v + nextV) / 2];
            return (
              <g key={`${i} ${k}`}>
                {!pull && (
                  <g onPointerDown={(event) => take(i, k + 1, event, true)}>
                    <circle cx={midU} cy={midV} r={TARGET / 1.6 / scale} className={styles.target} />
                    <circle cx={midU} cy={midV} r={6 / scale} className={styles.between} />
                  </g>
                )}
                <g
                  className={styles.corner}
                  tabIndex={0}
                  role="button"
                  aria-label={t("ui-corner-zone-arrow-keys-move-delete", { corner: k + 1, zone: i + 1 })}
                  onPointerDown={(event) => take(i, k, event)}
                  onKeyDown={(event) => key(i, k, event)}
                >
                  <circle cx={u} cy={v} r={TARGET / scale} className={styles.target} />
                  <circle cx={u} cy={v} r={HANDLE / scale} className={styles.handle} />
                </g>
              </g>
            );
          }),
        )}
    </svg>
  );
}

function rectangle([u0, v0]: [number, number], [u1, v1]: [number, number]): Zone {
  return [
    [u0, v0],
    [u1, v0],
    [u1, v1],
    [u0, v1],
  ];
}

function isLarge(zone: Zone): boolean {
  const [a, , c] = zone;
  return !!a && !!c && Math.abs(a[0] - c[0]) >= LEAST && Math.abs(a[1] - c[1]) >= LEAST;
}

function replaced<T>(all: T[], at: number, by: T): T[] {
  return all.map((one, i) => (i === at ? by : one));
}

function withCorner(all: Zone[], zone: number, at: number, corner: [number, number]): Zone[] {
  const grown = [...(all[zone] ?? [])];
  grown.splice(at, 0, corner);
  return replaced(all, zone, grown);
}

const WAYS: Record<string, [number, number]> = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowUp: [0, -STEP],
  ArrowDown: [0, STEP],
};

/** The zones after a key press; null if the key has no meaning here. */
function moved(all: Zone[], zone: number, corner: number, key: string): Zone[] | null {
  const corners = all[zone];
  const from = corners?.[corner];
  if (!corners || !from) return null;
  if (key === "Delete" || key === "Backspace") {
    if (corners.length <= 3) return all.filter((_, i) => i !== zone);
    return replaced(
      all,
      zone,
      corners.filter((_, i) => i !== corner),
    );
  }
  const way = WAYS[key];
  if (!way) return null;
  return replaced(all, zone, replaced(corners, corner, [from[0] + way[0], from[1] + way[1]]));
}
