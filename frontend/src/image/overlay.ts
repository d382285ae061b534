import type { Band, DetectedCorner, ImageCorner } from "../api/wire";
import { quantity } from "../messages/text";
import { t } from "../state/language";

/** For the corners of a result, the error is known. */
export type OverlayCorner = DetectedCorner & Partial<ImageCorner>;

export interface Overlay {
  corners: OverlayCorner[];
  outline: [number, number, number, number][];
  stripe: [number, number][];
}

/** For the picture, in every theme: they are drawn on a grey photograph. */
export const COLOURS = {
  outline: "#57b8ff",
  corner: "#ffe066",
  stripe: "#ff5a5f",
  target: "#7dff9b",
  saturated: "#ff3db8",
  band: "#9fe8ff",
};

/** Approximate distance between corners: their bounding box divided into one square each. */
export function spacing_px(corners: OverlayCorner[]): number {
  if (corners.length < 2) return Infinity;
  const range = (places: number[]) => Math.max(...places) - Math.min(...places);
  const [wide, tall] = [range(corners.map(({ u }) => u)), range(corners.map(({ v }) => v))];
  return Math.max(Math.sqrt((wide * tall) / corners.length), Math.max(wide, tall) / corners.length);
}

/** A corner's ring, not wider than this share of the space between corners, and still visible. */
const RING_SHARE = 0.2;
const RING_PX = { most: 6, least: 2 };

/** Pixel centres are whole numbers, so the frame begins half a pixel before (0, 0). */
export function drawOverlay(context: CanvasRenderingContext2D, overlay: Overlay, scale: number): void {
  const x = (u: number) => (u + 0.5) * scale;
  context.lineWidth = 1.5;
  context.strokeStyle = COLOURS.outline;
  context.beginPath();
  for (const [u0, v0, u1, v1] of overlay.outline) {
    context.moveTo(x(u0), x(v0));
    context.lineTo(x(u1), x(v1));
  }
  context.stroke();

  context.fillStyle = COLOURS.stripe;
  for (const [u, v] of overlay.stripe) context.fillRect(x(u) - 0.75, x(v) - 0.75, 1.5, 1.5);

  context.strokeStyle = COLOURS.corner;
  const ring = Math.max(RING_PX.least, Math.min(RING_PX.most, RING_SHARE * spacing_px(overlay.corners) * scale));
  context.lineWidth = ring < 4 ? 1.25 : 2;
  context.beginPath();
  for (const { u, v } of overlay.corners) {
    context.moveTo(x(u) + ring, x(v));
    context.arc(x(u), x(v), ring, 0, 2 * Math.PI);
  }
  context.stroke();
}

/** The target position of the object: dashed, to distinguish it from detections. */
export function drawTarget(
  context: CanvasRenderingContext2D,
  target: [number, number, number, number][],
  scale: number,
): void {
  const x = (u: number) => (u + 0.5) * scale;
  context.save();
  context.lineWidth = 3;
  context.setLineDash([10, 7]);
  context.strokeStyle = COLOURS.target;
  context.beginPath();
  for (const [u0, v0, u1, v1] of target) {
    context.moveTo(x(u0), x(v0));
    context.lineTo(x(u1), x(v1));
  }
  context.stroke();
  context.restore();
}

/** Overexposed regions: hatched, so that the picture stays visible. */
export function drawSaturated(
  context: CanvasRenderingContext2D,
  boxes: [number, number, number, number][],
  scale: number,
): void {
  if (boxes.length === 0) return;
  context.save();
  context.beginPath();
  for (const [left, top, width, height] of boxes) {
    context.rect(left * scale, top * scale, width * scale, height * scale);
  }
  context.clip();
  context.strokeStyle = COLOURS.saturated;
  context.lineWidth = 2;
  context.beginPath();
  const { width, height } = context.canvas;
  for (let x = -height; x < width; x += 7) {
    context.moveTo(x, 0);
    context.lineTo(x + height, height);
  }
  context.stroke();
  context.restore();
}

/** The lines between which the laser line should be, labelled with their distances. */
export function drawBand(context: CanvasRenderingContext2D, band: Band, scale: number): void {
  context.save();
  context.strokeStyle = COLOURS.band;
  context.fillStyle = COLOURS.band;
  context.lineWidth = 1.5;
  context.setLineDash([2, 5]);
  context.font = '600 13px "Inter Variable", system-ui, sans-serif';
  context.shadowColor = "#000";
  context.shadowBlur = 4;
  for (const [line, words] of [
    [band.near, t("ui-nearest", { value: quantity(band.near_mm, "mm") })],
    [band.far, t("ui-furthest", { value: quantity(band.far_mm, "mm") })],
  ] as const) {
    const first = line[0];
    if (!first) continue;
    context.beginPath();
    for (const [u, v] of line) context.lineTo((u + 0.5) * scale, (v + 0.5) * scale);
    context.stroke();
    context.fillText(words, first[0] * scale + 8, Math.max(14, first[1] * scale - 6));
  }
  context.restore();
}
