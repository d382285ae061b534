import { PressButton } from "../controls/PressButton";
import { t } from "../state/language";
import { go, usePage } from "../state/router";
import { useLive } from "../state/store";

/** Leads to the next step of Home, from another page. */
export function NextStep() {
  const page = usePage();
  const next = useLive((s) => s.home?.next);
  if (!next || next.page === page) return null;
  return (
    <PressButton free onPress={() => go(next.page)}>
      {t("ui-next", { what: next.label })}
    </PressButton>
  );
}
