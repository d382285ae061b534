import type { ObjectGeometry } from "../api/flowTypes";
import { t, words } from "../state/language";
import type { Values } from "../state/sentences";

const LEVELS: Record<string, string> = {
  crest: words("crest {n}"),
  floor: words("floor {n}"),
  wall: words("wall {n}"),
  base: words("base"),
};
const PLACES: Record<string, string> = {
  L: words("left"),
  R: words("right"),
  front: words("front"),
  back: words("back"),
  "L:front": words("front left"),
  "R:front": words("front right"),
  "L:back": words("back left"),
  "R:back": words("back right"),
};

const BOARD_CORNER = words("corner {column},{row}");

/**
 * "crest:2:L:front" as the trade says it: "crest 3, front left"; "3,2" of a board is its corner in
 * that column and row. A pose before it stays.
 */
export function cornerWords(name: string, say: (text: string, values?: Values) => string = t): string {
  const [, pose, rest = name] = /^pose (\d+) (.*)$/.exec(name) ?? [];
  if (pose) return `${say("Pose {n}", { n: pose })}: ${cornerWords(rest, say)}`;
  const [, column, row] = /^(?:corner )?(\d+),(\d+)$/.exec(name) ?? [];
  if (column && row) return say(BOARD_CORNER, { column, row });
  const [, level = "", number, place = ""] = /^(\w+)(?::(\d+))?(?::([\w:]+))?$/.exec(name) ?? [];
  const [where, part] = [PLACES[place], LEVELS[level]];
  if (!where || !part) return name;
  return `${say(part, { n: Number(number) + 1 })}, ${say(where)}`;
}

/** What of the object is measured in a picture, beside the stripe. */
export function partOf(object: ObjectGeometry): string {
  return object.kind === "board" ? words("Corners") : words("Edges");
}
