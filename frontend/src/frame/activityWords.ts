import type { Activity } from "../api/wire";
import { moment } from "../controls/format";
import { isolated } from "../state/isolated";
import { t } from "../state/language";

/** What has the arm, who works at it, and since when. */
export function activityWords({ title, who, since }: Activity): string {
  const at = moment(since);
  const today = moment(new Date().toISOString()).slice(0, 10);
  const when = at.startsWith(today) ? at.slice(11) : at;
  if (!who) return t("ui-activity-since", { title, since: when });
  return t("ui-activity-of-since", { title, who: isolated(who), since: when });
}
