import type { ShownMap } from "../api/wire";
import { unitOf } from "../controls/lengths";
import { BAR, type DrawLegend, write } from "../scan/savePicture";
import { t } from "../state/language";
import { DECISIONS, MODES, marksOf } from "./MapLegend";

const LINE = 24;

/** The legend of a map, in a saved picture. */
export const drawMapLegend =
  (shown: ShownMap): DrawLegend =>
  (pen, size) => {
    const { mode } = shown.legend;
    const left = size.width - BAR.width - BAR.margin;
    const title = t(MODES[mode].legend);
    if (mode === "significance") {
      const top = size.height - BAR.margin - LINE * DECISIONS.length;
      write(pen, title, left, top - 8);
      for (const [i, { name, colours }] of DECISIONS.entries()) drawSwatch(pen, colours, t(name), left, top + i * LINE);
    } else {
      const top = size.height - BAR.margin - BAR.height - 20;
      write(pen, `${title}, ${unitOf("µm")}`, left, top - 7);
      drawScale(pen, shown, left, top);
    }
  };

function drawSwatch(pen: CanvasRenderingContext2D, colours: string[], word: string, left: number, top: number): void {
  const ink = pen.fillStyle;
  for (const [i, colour] of colours.entries()) {
    pen.fillStyle = colour;
    pen.fillRect(left, top + (i * 16) / colours.length, 16, 16 / colours.length);
  }
  pen.strokeRect(left, top, 16, 16);
  pen.fillStyle = ink;
  write(pen, word, left + LINE, top + 14);
}

function drawScale(pen: CanvasRenderingContext2D, shown: ShownMap, left: number, top: number): void {
  const { colours } = shown.legend;
  const ink = pen.fillStyle;
  const shades = pen.createLinearGradient(left, 0, left + BAR.width, 0);
  for (const [i, colour] of colours.entries()) shades.addColorStop(i / (colours.length - 1), colour);
  pen.fillStyle = shades;
  pen.fillRect(left, top, BAR.width, BAR.height);
  pen.fillStyle = ink;
  for (const { at, text, limit } of marksOf(shown)) {
    const x = left + at * BAR.width;
    if (limit) pen.fillRect(x - 1, top - 2, 2, BAR.height + 4);
    pen.textAlign = at < 0.01 ? "left" : at > 0.99 ? "right" : "center";
    write(pen, text, x, top + BAR.height + 17);
  }
  pen.textAlign = "left";
}
