import type { ObjectGeometry } from "../api/types";
import type { PlainId, Text } from "../messages/text";
import { render } from "../state/language";

/** "crest:2:L:front" is "crest 3, front left"; "corner 3,2" of a board is the corner in that column and row. */
export function cornerName(corner: string): string {
  return render(cornerText(corner));
}

/** Like `corner_text` of the station. */
function cornerText(corner: string): Text {
  const [, column, row] = /^corner (\d+),(\d+)$/.exec(corner) ?? [];
  if (column && row) return { message_id: "corner", values: { column, row } };
  const [, level, number = "", place] = /^(crest|floor|base)(?::(\d+))?:([LR]:(?:front|back))$/.exec(corner) ?? [];
  if (!level || !place) return corner;
  return { message_id: "block-corner", values: { level, number: Number(number) + 1, place: place.replace(":", "-") } };
}

/** The measured features of the object in a picture, other than the stripe. */
export function partOf(object: ObjectGeometry): PlainId {
  return object.kind === "board" ? "ui-corners" : "ui-edges";
}
