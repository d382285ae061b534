import type { DatasheetsView, FieldRange } from "../api/wire";
import { typed } from "../controls/lengths";
import { t } from "../state/language";
import type { FormField, FormName } from "./forms";

export type Ranges = DatasheetsView["ranges"];

/** Between which limits a field's number is, in the displayed unit; "" where the station states none. */
export function rangeText(name: FormName, { key, unit = "", scale = 1 }: FormField, ranges: Ranges): string {
  const known = ranges[name] ?? {};
  const range: FieldRange | undefined = known[key] ?? known[key.replace(/\.\d+\./, ".*.")];
  if (!range) return "";
  const [low, high] = [range.least, range.most].map((limit) => (limit === null ? "" : typed(limit / scale, unit)));
  if (low && high) return t("ui-range", { low, high });
  return low ? t(range.above ? "ui-range-more-than" : "ui-range-at-least", { low }) : "";
}
