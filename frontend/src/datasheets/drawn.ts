import type { ObjectGeometry } from "../api/types";
import type { FormName } from "./forms";

type Plain = Record<string, unknown>;

const MOST_CORNERS = 200;

/** What a document describes, for drawing; null as long as it is nothing that can be drawn. */
export function drawn(name: FormName, document: Plain): ObjectGeometry | null {
  if (name === "block") return block(document);
  if (name === "chessboard") {
    const corners = Array.isArray(document.inner_corners) ? document.inner_corners : [];
    return board(corners[0], corners[1], document.square_mm, true);
  }
  if (name !== "charuco") return null;
  const [across, down] = [Number(document.squares_x), Number(document.squares_y)];
  // the upper left square is black, but in a present pattern of an even number of rows
  const first_is_black = down % 2 === 1 || document.legacy_pattern === true;
  return board(across - 1, down - 1, document.square_mm, first_is_black);
}

const ascends = (values: number[]) => values.every((value, i) => i === 0 || value > (values[i - 1] ?? value));

function numbers(document: Plain, keys: string[]): number[] | null {
  const values = keys.map((key) => document[key]);
  return values.every((value) => typeof value === "number") ? values : null;
}

function block(document: Plain): ObjectGeometry | null {
  const edges: unknown[] = Array.isArray(document.edges_x_mm) ? document.edges_x_mm : [];
  const depth = numbers(document, ["front_y_mm", "back_y_mm"]);
  const height = numbers(document, ["base_z_mm", "floor_z_mm", "crest_z_mm"]);
  if (edges.length < 4 || edges.length % 2 || !edges.every((edge) => typeof edge === "number")) return null;
  if (!depth || !height || ![edges, depth, height].every(ascends)) return null;
  const [front_y_mm = 0, back_y_mm = 0] = depth;
  const [base_z_mm = 0, floor_z_mm = 0, crest_z_mm = 0] = height;
  return { kind: "block", edges_x_mm: edges, front_y_mm, back_y_mm, crest_z_mm, floor_z_mm, base_z_mm };
}

function board(columns: unknown, rows: unknown, square_mm: unknown, first_is_black: boolean): ObjectGeometry | null {
  const isCount = (n: unknown): n is number => Number.isInteger(n) && Number(n) >= 2 && Number(n) <= MOST_CORNERS;
  if (!isCount(columns) || !isCount(rows) || typeof square_mm !== "number" || square_mm <= 0) return null;
  return { kind: "board", inner_corners: [columns, rows], square_mm, first_is_black };
}
