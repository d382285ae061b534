import type { ImageCorner } from "../api/types";

export interface Overlay {
  corners: ImageCorner[];
  outline: [number, number, number, number][];
  stripe: [number, number][];
}

/** Of the picture, whatever the scheme: they lie on a grey photograph. */
export const COLOURS = { outline: "#57b8ff", corner: "#ffe066", stripe: "#ff5a5f", target: "#7dff9b" };

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
  context.lineWidth = 2;
  context.beginPath();
  for (const { u, v } of overlay.corners) {
    context.moveTo(x(u) + 6, x(v));
    context.arc(x(u), x(v), 6, 0, 2 * Math.PI);
  }
  context.stroke();
}

/** Where the object should come to lie: dashed, so that it is not taken for what was found. */
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
