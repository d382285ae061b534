import { plainCell, plainHead, type TableData } from "./table";

function cell(text: string): string {
  const plain = text.replaceAll("\u2212", "-").replaceAll("\u2009", "");
  return /[",\n]/.test(plain) ? `"${plain.replaceAll('"', '""')}"` : plain;
}

/** One table after another, an empty line between them; in English, mm and µm, whatever is shown. */
export function toCsv(tables: TableData[]): string {
  return tables
    .map(({ title, head, rows }) => [[title], head.map(plainHead), ...rows.map((row) => row.map(plainCell))])
    .map((lines) => lines.map((line) => line.map(cell).join(",")).join("\n"))
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
