import type { NewDatasheet } from "../api/datasheetCommands";
import { notify } from "../state/banner";
import { t } from "../state/language";

/** The station takes no more at once; a datasheet has some kilobytes. */
const LARGEST_BYTES = 200_000;

/** A file that a person gives; null, and said why, of one that is no datasheet. */
export async function readDatasheet(file: File): Promise<NewDatasheet | null> {
  if (file.size > LARGEST_BYTES) {
    notify({ quality: "attention", title: t("ui-file-is-larger-than-datasheets", { name: file.name }) });
    return null;
  }
  try {
    const text = new TextDecoder("utf-8", { fatal: true }).decode(await file.arrayBuffer());
    return { name: file.name.slice(-200), text, edited: "" };
  } catch {
    notify({ quality: "attention", title: t("ui-datasheet-is-not-utf-8", { name: file.name }) });
    return null;
  }
}
