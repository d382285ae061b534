import { useElementSize } from "@mantine/hooks";
import { type ReactNode, useEffect, useRef, useState } from "react";
import { flushSync } from "react-dom";
import { type Preview, watchPreview } from "../api/preview";
import type { CaptureAid, PreviewHeader } from "../api/wire";
import { newFindings } from "../controls/findings";
import { age, figures } from "../controls/format";
import { lengthFigures, unitOf } from "../controls/lengths";
import { QualityMark } from "../controls/QualityMark";
import { Readouts } from "../controls/Readouts";
import { t } from "../state/language";
import { asSent } from "../state/localized";
import { useLive } from "../state/store";
import styles from "./LiveCamera.module.css";
import { drawBand, drawOverlay, drawSaturated, drawTarget } from "./overlay";
import { useRate } from "./useRate";

const OLD_S = 1;
/** After this many seconds, the reason for the old picture is shown. */
const AWAY_S = 2;

const LASER = { on: "ui-on", off: "ui-off", unknown: "ui-unknown" } as const;

type Target = [number, number, number, number][];

/** The size of the picture, and the number of screen pixels per picture pixel. */
export interface Frame {
  width_px: number;
  height_px: number;
  scale: number;
}

interface LiveCameraProps {
  /** The target position of the object. */
  target?: Target;
  /** An overlay with the size of the picture. */
  over?: (frame: Frame) => ReactNode;
  /** Without the figures below. */
  bare?: boolean;
}

/** The camera as it sees now, with corners, outline and stripe drawn on it. */
export function LiveCamera({ target = [], over, bare = false }: LiveCameraProps) {
  const { ref, width, height } = useElementSize<HTMLDivElement>();
  const canvas = useRef<HTMLCanvasElement>(null);
  const space = useRef({ width, height });
  space.current = { width, height };
  const wanted = useRef(target);
  wanted.current = target;
  const newest = useRef(0);
  const shown = useRef(false);
  const [header, setHeader] = useState<PreviewHeader | null>(null);
  const { rate, count } = useRate();

  useEffect(
    () =>
      watchPreview((preview) => {
        // before the first picture is drawn, so that the words for none never lie over one
        if (!shown.current) flushSync(() => setHeader(preview.header));
        shown.current = true;
        if (canvas.current) paint(canvas.current, preview, space.current, wanted.current);
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
      <div ref={ref} className={styles.space}>
        <canvas
          ref={canvas}
          className={styles.canvas}
          data-old={old || undefined}
          role="img"
          aria-label={t("ui-live-picture-of-the-camera")}
        />
        {header && over && <Over header={header} width={width} height={height} over={over} />}
        {header && !old && <Aims aids={header.aids} />}
        {header && old_s > AWAY_S && <Away old_s={old_s} />}
        {!header && <p className={styles.waiting}>{t("ui-no-picture-yet-appears-when-camera")}</p>}
      </div>
      {header && !bare && <Panel header={header} old_s={old ? old_s : null} line={over !== undefined} rate={rate} />}
    </div>
  );
}

/** Why the picture is frozen, and that it resumes automatically. */
function Away({ old_s }: { old_s: number }) {
  const heard = useLive((s) => s.connection === "live");
  const sensor = useLive((s) => s.devices?.sensor.state ?? "lost");
  const values = { age: age(old_s) };
  const why = !heard
    ? t("ui-station-offline-picture-old", values)
    : sensor === "lost" || sensor === "off"
      ? t("ui-camera-offline-picture-old", values)
      : t("ui-no-new-picture-for", values);
  return (
    <p className={styles.away} role="status">
      {`${why} ${t("ui-the-live-picture-resumes-automatically")}`}
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
  space: { width: number; height: number },
  target: Target,
): void {
  const { width_px, height_px } = preview.header;
  const fit = Math.min(space.width / width_px, space.height / height_px);
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
  /** The laser line is of interest, not the object. */
  line: boolean;
  /** Pictures per second received by this screen. */
  rate: number;
}

/** Quality figures of the newest picture, and problems that are not among the findings of the card. */
function Panel({ header, old_s, line, rate }: PanelProps) {
  const onCard = useLive((s) => s.flow?.findings) ?? [];
  const laser = useLive((s) => s.devices?.laser.state ?? "unknown");
  const texts = onCard.map((finding) => asSent(finding).text);
  const serious = line ? [] : header.findings.filter(({ quality }) => quality === "attention" || quality === "bad");
  const wrong = newFindings(serious, [], texts);
  return (
    <>
      {wrong.length > 0 && (
        <ul className={styles.wrong} aria-label={t("ui-picture-details")}>
          {wrong.map(({ quality, text, remedy }) => (
            <li key={text}>
              <QualityMark quality={quality} size="1.25rem" />
              {text} {remedy}
            </li>
          ))}
        </ul>
      )}
      <Readouts
        readouts={[
          old_s === null
            ? {
                label: t("ui-picture"),
                value: age(header.age_s),
                unit: t("ui-old"),
                note: rate ? `${figures(rate)}/s` : "",
              }
            : { label: t("ui-picture"), value: age(old_s), unit: t("ui-old"), quality: "bad" },
          { label: t("ui-laser"), value: t(LASER[laser]) },
          {
            label: t("ui-arm"),
            value: header.arm_still ? t("ui-still") : t("ui-moving"),
            quality: header.arm_still ? "good" : "attention",
          },
          line
            ? { label: t("ui-line"), value: header.stripe.length > 0 ? t("ui-found") : t("ui-none") }
            : { label: t("ui-corners"), value: figures(header.corners.length) },
          ...header.aids.map(({ title, value, unit, decimals, quality, wanted }) => ({
            label: title,
            value: lengthFigures(value, unit, decimals),
            unit: unitOf(unit),
            quality,
            note: wanted,
          })),
        ]}
      />
    </>
  );
}

/** How to aim, in large letters. */
function Aims({ aids }: { aids: CaptureAid[] }) {
  const aiming = aids.filter(({ words }) => words);
  if (aiming.length === 0) return null;
  return (
    <ul className={styles.aims} aria-label={t("ui-to-aim-expose-and-focus")}>
      {aiming.map(({ name, quality, words }) => (
        <li key={name}>
          <QualityMark quality={quality} size="1.375rem" />
          {words}
        </li>
      ))}
    </ul>
  );
}
