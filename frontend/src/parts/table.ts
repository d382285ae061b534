import { said, t } from "../state/language";
import { figures, signed } from "./format";
import { lengthFigures, unitOf } from "./lengths";

/** A number of the station's; `plus` where its sign is always told. */
export interface Amount {
  value: number;
  decimals: number;
  unit: string;
  plus: boolean;
}

/** Words of this browser: as they are copied, and as they are shown. */
interface Words {
  plain: string;
  shown: string;
}

/** Words of the station stand as they are. */
export type Cell = string | Amount | Words | { unit: string };
/** A column's head, with its unit where all of it has one. */
export type Head = string | { words: string; unit: string };

export interface TableData {
  title: string;
  head: Head[];
  rows: Cell[][];
  /** Takes the whole width where others stand side by side. */
  wide?: boolean;
}

export function amount(value: number, decimals: number, unit = "", plus = false): Amount {
  return { value, decimals, unit, plus };
}

/** As it is copied: in the station's units. */
export function plainCell(cell: Cell): string {
  if (typeof cell === "string") return cell;
  if ("plain" in cell) return cell.plain;
  if (!("value" in cell)) return cell.unit;
  return cell.plus ? signed(cell.value, cell.decimals) : figures(cell.value, cell.decimals);
}

export function plainHead(head: Head): string {
  if (typeof head === "string") return head;
  return [head.words, head.unit].filter(Boolean).join(", ");
}

/** As it is shown: in this browser's units. */
export function shownCell(cell: Cell): string {
  if (typeof cell === "string") return said(cell);
  if ("plain" in cell) return cell.shown;
  if (!("value" in cell)) return unitOf(cell.unit);
  return lengthFigures(cell.value, cell.unit, cell.decimals, cell.plus);
}

export function shownHead(head: Head): string {
  if (typeof head === "string") return t(head);
  return [t(head.words), unitOf(head.unit)].filter(Boolean).join(", ");
}
