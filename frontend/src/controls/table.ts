import { isQuantity, message, type PlainId, type Text } from "../messages/text";
import { render, renderEnglish } from "../state/language";
import { plainFigures } from "./figures";
import { lengthFigures, unitOf } from "./lengths";

/** The unit of a number is that of its column, or in a separate cell. */
export type Cell = Text | { unit: string };
/** The header of a column, with its unit if it has one. */
export type Head = PlainId | { title: PlainId; unit: string } | { symbol: string; unit?: string };

export interface TableData {
  title: PlainId;
  head: Head[];
  rows: Cell[][];
  /** Takes the full width where others are side by side. */
  wide?: boolean;
}

/** As in a file: in English, and in the station's units. */
export function fileCell(cell: Cell): string {
  if (typeof cell === "string") return cell;
  if (isQuantity(cell)) return plainFigures(cell.value, cell.decimals);
  return "unit" in cell ? cell.unit : renderEnglish(cell);
}

export function fileHead(head: Head): string {
  return headOf(head, renderEnglish, (unit) => unit);
}

/** As displayed: in this browser's language and units. */
export function displayedCell(cell: Cell): string {
  if (typeof cell === "string") return cell;
  if (isQuantity(cell)) return lengthFigures(cell.value, cell.unit, cell.decimals, cell.signed);
  return "unit" in cell ? unitOf(cell.unit) : render(cell);
}

export function displayedHead(head: Head): string {
  return headOf(head, render, unitOf);
}

function headOf(head: Head, words: (text: Text) => string, unit: (unit: string) => string): string {
  if (typeof head === "string") return words(message(head));
  const title = "symbol" in head ? head.symbol : words(message(head.title));
  return [title, unit(head.unit ?? "")].filter(Boolean).join(", ");
}
