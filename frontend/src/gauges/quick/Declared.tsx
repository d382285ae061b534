import type { FiltersPart, RulePart } from "../../api/wire";
import { quantity } from "../../messages/text";
import { t } from "../../state/language";
import styles from "./ResultTabs.module.css";

interface DeclaredProps {
  rule: RulePart | null;
  filters: FiltersPart | null;
  /** Whether figures state test value and measurement uncertainty apart. */
  both: boolean;
}

/** By what the figures were judged, and what chose their points. */
export function Declared({ rule, filters, both }: DeclaredProps) {
  return (
    <>
      {rule && <p className={styles.note}>{ruleText(rule)}</p>}
      {both && <p className={styles.note}>{t("ui-limits-judged-by-uncertainty-on-bar")}</p>}
      {filters && <p className={styles.note}>{filterText(filters)}</p>}
    </>
  );
}

function ruleText({ name, standard, edition, guard_factor, bearer }: RulePart): string {
  const named = t("ui-rule-named", { name, standard, edition });
  if (guard_factor === 0) return `${named} ${t("ui-rule-without-guard")}`;
  const factor = quantity(guard_factor, "", Number.isInteger(guard_factor) ? 0 : 2);
  return `${named} ${t("ui-rule-guard", { factor, bearer: bearer ?? "prover" })}`;
}

function filterText({ sigmas, same_place_mm, gate_mm, gate_deg }: FiltersPart): string {
  const used = t("ui-filters-used", { sigmas: quantity(sigmas, ""), place: quantity(same_place_mm, "mm", 2) });
  const gate = quantity(gate_mm, "mm");
  const chosen =
    typeof gate_deg === "number"
      ? t("ui-gate-of-sphere", { gate, angle: quantity(gate_deg, "°") })
      : t("ui-gate-of-plane", { gate });
  return `${used} ${chosen}`;
}
