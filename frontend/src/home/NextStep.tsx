import { PressButton } from "../parts/PressButton";
import { languageNow, t } from "../state/language";
import { go, usePage } from "../state/router";
import { useLive } from "../state/store";

/** As it stands within a sentence; German nouns stay as they are. */
function inner(label: string): string {
  return languageNow() === "de" ? label : label.charAt(0).toLowerCase() + label.slice(1);
}

/** Leads on to what Home says comes next, from a page that is not it. */
export function NextStep() {
  const page = usePage();
  const next = useLive((s) => s.home?.next);
  if (!next || next.page === page) return null;
  return (
    <PressButton free onPress={() => go(next.page)}>
      {t("Next: {what}", { what: inner(next.label) })}
    </PressButton>
  );
}
