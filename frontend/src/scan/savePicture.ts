import type { Legend } from "../api/wire";
import { figures } from "../controls/format";
import { saveFile } from "../controls/saveFile";
import { getState } from "../state/store";
import { decimalsOf, inDisplayedUnit, referenceOf, titleOf } from "./LegendBar";

interface Size {
  width: number;
  height: number;
}
export type DrawLegend = (pen: CanvasRenderingContext2D, size: Size) => void;

/** Saves the current 3D view with its legend as PNG; false if there is none yet. */
export async function savePicture(
  frame: HTMLIFrameElement,
  legend: DrawLegend | null,
  station: string,
): Promise<boolean> {
  const canvases = Array.from(frame.contentDocument?.querySelectorAll("canvas") ?? []);
  const scene = canvases.sort((a, b) => b.width * b.height - a.width * a.height)[0];
  const page = document.createElement("canvas");
  const pen = page.getContext("2d");
  if (!scene?.width || !pen) return false;
  page.width = scene.width;
  page.height = scene.height;
  const colour = (name: string) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  pen.fillStyle = colour("--picture");
  pen.fillRect(0, 0, page.width, page.height);
  pen.drawImage(scene, 0, 0);
  const scale = scene.width / Math.max(frame.clientWidth, 1);
  pen.scale(scale, scale);
  pen.fillStyle = colour("--ink");
  const at = new Date();
  const size = { width: page.width / scale, height: page.height / scale };
  write(pen, `${station} · ${stampOf(at, " ", ":")}`, 16, size.height - 16);
  legend?.(pen, size);
  const blob = await new Promise<Blob | null>((done) => page.toBlob(done, "image/png"));
  if (!blob) return false;
  saveFile(blob, `crenel-${stampOf(at, "-", "")}.png`);
  return true;
}

export const BAR = { width: 280, height: 14, margin: 16 };

/** The legend of a cloud. */
export const drawLegend =
  (legend: Legend): DrawLegend =>
  (pen, size) => {
    const left = size.width - BAR.width - BAR.margin;
    const top = size.height - BAR.margin - BAR.height - 20;
    const shades = pen.createLinearGradient(left, 0, left + BAR.width, 0);
    for (const [i, colour] of legend.colours.entries()) shades.addColorStop(i / (legend.colours.length - 1), colour);
    const { low, high, unit } = inDisplayedUnit(legend);
    write(pen, `${titleOf(legend, referenceOf(getState()))}, ${unit}`, left, top - 7);
    const ink = pen.fillStyle;
    pen.fillStyle = shades;
    pen.fillRect(left, top, BAR.width, BAR.height);
    pen.fillStyle = ink;
    const values = [low, (low + high) / 2, high];
    const sides: CanvasTextAlign[] = ["left", "center", "right"];
    values.forEach((value, i) => {
      pen.textAlign = sides[i] ?? "left";
      write(pen, figures(value, decimalsOf({ low, high })), left + (i * BAR.width) / 2, top + BAR.height + 17);
    });
    pen.textAlign = "left";
  };

export function write(pen: CanvasRenderingContext2D, text: string, x: number, y: number): void {
  pen.font = '500 15px "Inter Variable", system-ui, sans-serif';
  pen.fillText(text, x, y);
}

function stampOf(at: Date, between: string, colon: string): string {
  const two = (part: number) => String(part).padStart(2, "0");
  const day = `${at.getFullYear()}-${two(at.getMonth() + 1)}-${two(at.getDate())}`;
  return day + between + [at.getHours(), at.getMinutes(), at.getSeconds()].map(two).join(colon);
}
