import { useElementSize } from "@mantine/hooks";
import { type ReactNode, useEffect, useRef, useState } from "react";

import { type Preview, watchPreview } from "../api/preview";
import type { Aid, PreviewHeader } from "../api/deviceTypes";
import { age, bound, figures } from "../parts/format";
import { inUnits, lengthFigures, unitOf } from "../parts/lengths";
import { QualityMark } from "../parts/QualityMark";
import { Readouts } from "../parts/Readouts";
import { t } from "../state/language";
import { useLive } from "../state/store";
import styles from "./LiveCamera.module.css";
import { drawBand, drawOverlay, drawSaturated, drawTarget } from "./overlay";
import { useRate } from "./useRate";

const OLD_S = 1;
/** From so many seconds on it is said why there is no newer picture. */
const AWAY_S = 2;

type Target = [number, number, number, number][];

/** The picture's size, and how many of the screen's pixels one of its own takes. */
export interface Frame {
  width_px: number;
  height_px: number;
  scale: number;
}

interface LiveCameraProps {
  /** How the object should come to lie. */
  target?: Target;
  /** What lies on the picture, of its own size. */
  over?: (frame: Frame) => ReactNode;
  /** Without the figures below. */
  bare?: boolean;
}

/** The camera as it sees now, with corners, outline and stripe drawn on it. */
export function LiveCamera({ target = [], over, bare = false }: LiveCameraProps) {
  const { ref, width, height } = useElementSize<HTMLDivElement>();
  const canvas = useRef<HTMLCanvasElement>(null);
  const room = useRef({ width, height });
  room.current = { width, height };
  const wanted = useRef(target);
  wanted.current = target;
  const newest = useRef(0);
  const [header, setHeader] = useState<PreviewHeader | null>(null);
  const { rate, count } = useRate();

  useEffect(
    () =>
      watchPreview((preview) => {
        if (canvas.current) paint(canvas.current, preview, room.current, wanted.current);
        newest.current = preview.at - preview.header.age_s * 1000;
        count();
        setHeader(preview.header);
      }),
    [count],
  );
  const old_s = useAge(newest);
  const old = header !== null && old_s > OLD_S;
  return (
    <div className={styles.camera} data-bare={bare || undefined}>
      <div ref={ref} className={styles.room}>
        <canvas
          ref={canvas}
          className={styles.canvas}
          data-old={old || undefined}
          role="img"
          aria-label={t("Live picture of the camera")}
        />
        {header && over && <Over header={header} width={width} height={height} over={over} />}
        {header && !old && <Aims aids={header.aids} />}
        {header && old_s > AWAY_S && <Away old_s={old_s} />}
        {!header && <p className={styles.waiting}>{t("No picture yet. It appears when the camera sends one.")}</p>}
      </div>
      {header && !bare && <Panel header={header} old_s={old ? old_s : null} line={over !== undefined} rate={rate} />}
    </div>
  );
}

/** Why the picture stands still, and that nothing need be done for its return. */
function Away({ old_s }: { old_s: number }) {
  const heard = useLive((s) => s.connection === "live");
  const sensor = useLive((s) => s.devices?.sensor.state ?? "lost");
  const values = { age: age(old_s) };
  const why = !heard
    ? t("The station is away, and this picture {age} old.", values)
    : sensor === "lost" || sensor === "off"
      ? t("The camera is away, and this picture {age} old.", values)
      : t("No newer picture has come for {age}.", values);
  return (
    <p className={styles.away} role="status">
      {bound(`${why} ${t("The picture goes on by itself.")}`)}
    </p>
  );
}

interface OverProps {
  header: PreviewHeader;
  width: number;
  height: number;
  over: (frame: Frame) => ReactNode;
}

function Over({ header: { width_px, height_px }, width, height, over }: OverProps) {
  const scale = Math.min(width / width_px, height / height_px);
  if (!(scale > 0)) return null;
  return (
    <div className={styles.over} style={{ width: width_px * scale, height: height_px * scale }}>
      {over({ width_px, height_px, scale })}
    </div>
  );
}

function paint(
  canvas: HTMLCanvasElement,
  preview: Preview,
  room: { width: number; height: number },
  target: Target,
): void {
  const { width_px, height_px } = preview.header;
  const fit = Math.min(room.width / width_px, room.height / height_px);
  const density = window.devicePixelRatio;
  const width = Math.max(1, Math.round(width_px * fit * density));
  const height = Math.max(1, Math.round(height_px * fit * density));
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
    canvas.style.width = `${width / density}px`;
    canvas.style.height = `${height / density}px`;
  }
  const context = canvas.getContext("2d");
  if (!context) return;
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.drawImage(preview.image, 0, 0, width, height);
  context.scale(density, density);
  drawSaturated(context, preview.header.saturated, fit);
  if (preview.header.band) drawBand(context, preview.header.band, fit);
  drawTarget(context, target, fit);
  drawOverlay(context, preview.header, fit);
}

function useAge(newest: { current: number }): number {
  const [age_s, setAge] = useState(0);
  useEffect(() => {
    const timer = setInterval(() => setAge((performance.now() - newest.current) / 1000), 250);
    return () => clearInterval(timer);
  }, [newest]);
  return age_s;
}

interface PanelProps {
  header: PreviewHeader;
  old_s: number | null;
  /** The laser's line is looked at, not the object. */
  line: boolean;
  /** Pictures a second, as they come to this screen. */
  rate: number;
}

/** What the newest picture is worth, in figures, and what is wrong with it beyond the card's findings. */
function Panel({ header, old_s, line, rate }: PanelProps) {
  const told = useLive((s) => s.flow?.findings);
  const wrong = header.findings.filter(
    ({ quality, text }) =>
      !line &&
      (quality === "attention" || quality === "bad") && !told?.some((finding) => bare(finding.text) === bare(text)),
  );
  return (
    <>
      {wrong.length > 0 && (
        <ul className={styles.wrong} aria-label={t("About the picture")}>
          {wrong.map(({ quality, text, remedy }) => (
            <li key={text}>
              <QualityMark quality={quality} size="1.25rem" />
              {text}
              {remedy && `. ${remedy}`}
            </li>
          ))}
        </ul>
      )}
      <Readouts
        readouts={[
          old_s === null
            ? { label: t("Picture"), value: age(header.age_s), unit: t("old"), note: rate ? `${figures(rate)}/s` : "" }
            : { label: t("Picture"), value: age(old_s), unit: t("old"), quality: "bad" },
          { label: t("Laser"), value: header.laser_on ? t("on") : t("off") },
          { label: t("Arm"), value: header.arm_still ? t("still") : t("moving"), quality: header.arm_still ? "good" : "attention" },
          line
            ? { label: t("Line"), value: header.stripe.length > 0 ? t("found") : t("none") }
            : { label: t("Corners"), value: figures(header.corners.length) },
          ...header.aids.map(({ title, value, unit, decimals, quality, wanted }) => ({
            label: title,
            value: lengthFigures(value, unit, decimals),
            unit: unitOf(unit),
            quality,
            note: inUnits(`${wanted} ${unit}`),
          })),
        ]}
      />
    </>
  );
}

/** The card ends its sentences, the picture's words have no end. */
function bare(text: string): string {
  return text.replace(/\.$/, "");
}

/** Which way to go, readable with the part in one hand. */
function Aims({ aids }: { aids: Aid[] }) {
  const told = aids.filter(({ words }) => words);
  if (told.length === 0) return null;
  return (
    <ul className={styles.aims} aria-label={t("To aim, expose and focus")}>
      {told.map(({ name, quality, words }) => (
        <li key={name}>
          <QualityMark quality={quality} size="1.375rem" />
          {bound(words)}
        </li>
      ))}
    </ul>
  );
}
