import type { ObjectGeometry } from "../api/types";
import type { FlatShape } from "./FlatDrawing";
import type { FormName } from "./forms";

type Plain = Record<string, unknown>;

const MOST_CORNERS = 200;
/** Beyond it, in mm or pixels, nothing is drawn: nothing would be seen. */
const FARTHEST = 1e6;
/** As the station selects the channel of a colour picture. */
const LONGEST_BLUE_NM = 495;
const LONGEST_GREEN_NM = 585;

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

/** The same of a gauge or a sensor. */
export function drawnFlat(name: FormName, document: Plain): FlatShape | null {
  if (name === "sensor") return sensor(document);
  if (name === "ball-bar" || name === "step-gauge") {
    const parts = Array.isArray(document.lengths) ? (document.lengths as Plain[]) : [];
    const lengths_mm = parts.map(({ length_mm }) => length_mm).filter(isSize);
    const diameter_mm = isSize(document.sphere_diameter_mm) ? document.sphere_diameter_mm : null;
    return lengths_mm.length ? { kind: "lengths", spheres: name === "ball-bar", lengths_mm, diameter_mm } : null;
  }
  const { radius_mm, width_mm } = document;
  if (name === "sphere" && isSize(radius_mm)) return { kind: "sphere", diameter_mm: 2 * radius_mm };
  return name === "plane" && isSize(width_mm) ? { kind: "plate", width_mm } : null;
}

function sensor({ width_px, height_px, stripe_axis, laser_wavelength_nm, focal_px, standoff_mm }: Plain) {
  if (!isSize(width_px) || !isSize(height_px)) return null;
  const nm = isSize(laser_wavelength_nm) ? laser_wavelength_nm : Number.POSITIVE_INFINITY;
  const times = isSize(focal_px) && isSize(standoff_mm) ? standoff_mm / focal_px : null;
  return {
    kind: "sensor",
    width_px,
    height_px,
    stripe_axis: stripe_axis === "v" ? "v" : "u",
    laser: nm <= LONGEST_BLUE_NM ? "blue" : nm <= LONGEST_GREEN_NM ? "green" : "red",
    field:
      times === null
        ? null
        : { width_mm: width_px * times, height_mm: height_px * times, standoff_mm: Number(standoff_mm) },
  } satisfies FlatShape;
}

const isPlace = (value: unknown): value is number => typeof value === "number" && Math.abs(value) <= FARTHEST;

const isSize = (value: unknown): value is number => isPlace(value) && value > 0;

const ascends = (values: number[]) => values.every((value, i) => i === 0 || value > (values[i - 1] ?? value));

function numbers(document: Plain, keys: string[]): number[] | null {
  const values = keys.map((key) => document[key]);
  return values.every(isPlace) ? values : null;
}

function block(document: Plain): ObjectGeometry | null {
  const edges: unknown[] = Array.isArray(document.edges_x_mm) ? document.edges_x_mm : [];
  const depth = numbers(document, ["front_y_mm", "back_y_mm"]);
  const height = numbers(document, ["base_z_mm", "floor_z_mm", "crest_z_mm"]);
  if (edges.length < 4 || edges.length % 2 || !edges.every(isPlace)) return null;
  if (!depth || !height || ![edges, depth, height].every(ascends)) return null;
  const [front_y_mm = 0, back_y_mm = 0] = depth;
  const [base_z_mm = 0, floor_z_mm = 0, crest_z_mm = 0] = height;
  return { kind: "block", edges_x_mm: edges, front_y_mm, back_y_mm, crest_z_mm, floor_z_mm, base_z_mm };
}

function board(columns: unknown, rows: unknown, square_mm: unknown, first_is_black: boolean): ObjectGeometry | null {
  const isCount = (n: unknown): n is number => Number.isInteger(n) && Number(n) >= 2 && Number(n) <= MOST_CORNERS;
  if (!isCount(columns) || !isCount(rows) || !isSize(square_mm)) return null;
  return { kind: "board", inner_corners: [columns, rows], square_mm, first_is_black };
}
