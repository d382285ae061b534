import type { ShapeName } from "../api/types";
import type { FittedShape } from "../api/wire";
import type { PlainId } from "../messages/text";
import { t } from "../state/language";

export const NAMES: Record<ShapeName, PlainId> = {
  plane: "ui-plane",
  cylinder: "ui-cylinder",
  sphere: "ui-sphere",
  cone: "ui-cone",
};

/** As the card and the picture call it. */
export const nameOf = ({ shape, id }: Pick<FittedShape, "shape" | "id">) => `${t(NAMES[shape])} ${id}`;
