import { message } from "../messages/text";
import { renderEnglish } from "../state/language";
import { fileCell, fileHead, type TableData } from "./table";

/** A text that a spreadsheet program would run begins with an apostrophe; numbers stay numbers. */
function guarded(text: string): string {
  return /^'*(\s*[=+\-@]|[\t\r])/.test(text) && Number.isNaN(Number(text)) ? `'${text}` : text;
}

function quoted(text: string): string {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** One table after another, an empty line between them; in English, mm and µm, whatever is displayed. */
export function toCsv(tables: TableData[]): string {
  return tables
    .map(({ title, head, rows }) => [
      [renderEnglish(message(title))],
      head.map(fileHead),
      ...rows.map((row) => row.map(fileCell)),
    ])
    .map((lines) => lines.map((line) => line.map(guarded).map(quoted).join(",")).join("\n"))
    .join("\n\n");
}

/** Copies; the older way serves stations reached over plain http. */
export async function copyText(text: string): Promise<boolean> {
  if (navigator.clipboard) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      /* not allowed: the older way */
    }
  }
  const area = document.createElement("textarea");
  area.value = text;
  area.style.position = "fixed";
  area.style.opacity = "0";
  document.body.append(area);
  area.select();
  const copied = document.execCommand("copy");
  area.remove();
  return copied;
}
